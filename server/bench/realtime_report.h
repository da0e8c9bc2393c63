// What `cloudscape bench realtime` says: a table for people, and JSON.
#pragma once
#include <optional>
#include <string>

#include "bench/flight_figures.h"
#include "bench/machine.h"
#include "bench/moving_quality.h"
#include "bench/thread_times.h"

namespace cloudscape::bench {

struct RealtimeResults {
  std::string cloudscape, path;
  ImageSize size_px;
  double speed = 1, speed_m_per_s = 0, target_fps = 30, poses_per_s = 60, latency_ms = 0;
  FlightFigures flight;
  double cpu_ms = 0;    // of the whole process, of a frame
  ThreadTimes threads;  // of a frame, by what the threads do
  std::optional<MovingQuality> quality;
  QualityRun judged;  // how the quality was judged
};

std::string realtime_table(const RealtimeResults& results);
std::string realtime_json(const RealtimeResults& results, const Machine& machine);

// Of the frames that were compared.
struct QualityFigures {
  double flip_mean = 0, flip_worst = 0, psnr_mean_db = 0, psnr_worst_db = 0;
};
QualityFigures figures_of(const std::vector<ComparedFrame>& compared);

}  // namespace cloudscape::bench
