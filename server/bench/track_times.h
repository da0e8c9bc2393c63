// What frames cost along a camera path, variant beside variant: the run, and the statistics of what it measured.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "bench/track_variants.h"
#include "render/renderer.h"
#include "settings/camera_path.h"

namespace cloudscape::bench {

// wall: from the request to the pixels in memory. device: by timer queries. cpu: of all threads of this process.
struct FrameSample {
  double wall_ms = 0, device_ms = 0, cpu_ms = 0;
  bool operator==(const FrameSample&) const = default;
};
enum class TimeKind { wall, device, cpu };
constexpr TimeKind time_kinds[] = {TimeKind::wall, TimeKind::device, TimeKind::cpu};

}  // namespace cloudscape::bench

namespace cloudscape {
template <>
struct EnumNames<bench::TimeKind> {
  static constexpr std::array<std::string_view, 3> names{"wall", "device", "cpu"};
};
}  // namespace cloudscape

namespace cloudscape::bench {

struct VariantTimes {
  TrackVariant variant = TrackVariant::base;
  std::vector<FrameSample> frames;
};

struct TrackTimes {
  std::string cloudscape, path;
  ImageSize size_px;
  March base_march;
  std::vector<double> time_s;         // of each frame on the path
  std::vector<std::string> sections;  // of each frame; "" in none
  std::vector<VariantTimes> variants;
};

// Renders `frames` frames, in the middles of as many equal parts of the path, once for each variant, frame by frame, so
// that a machine that slows down slows them all; the order rotates from frame to frame. Before each a small picture
// that is not counted fills what the variants share (the sky's tables), and before all the first frame is drawn
// `warm_up` times, which bakes and compiles. `progress`: the share that is done.
using Draw = std::function<FrameSample(const FrameRequest&)>;
struct TrackRun {
  int frames = 0, warm_up = 2;
  std::function<void(double)> progress = [](double) {};
};
TrackTimes run_track(const settings::CameraPath& path, const std::vector<FrameRequest>& variants, const TrackRun& run,
                     const Draw& draw);

// Renders and measures. Each frame begins anew; only its buffers are those of the frame before.
FrameSample timed_frame(render::Renderer& renderer, const FrameRequest& request);

// The times of one kind, frame by frame.
std::vector<double> times_of(const VariantTimes& variant, TimeKind kind);

struct Summary {
  double mean_ms = 0, median_ms = 0, p95_ms = 0;
};
Summary summary_of(const std::vector<double>& times_ms);
double mean_of(const std::vector<double>& values);  // 0 of none

// `times` over `base`, which are of the same frames; 0 where base has no time.
struct PairedRatio {
  double of_means = 0, median = 0;  // ratio of the means; median of the frames' ratios
};
std::vector<double> ratios_of(const std::vector<double>& times_ms, const std::vector<double>& base_ms);
PairedRatio paired_ratio(const std::vector<double>& times_ms, const std::vector<double>& base_ms);

// The section's frames among `values`, which has one for each frame.
std::vector<double> in_section(const TrackTimes& track, const std::vector<double>& values, const std::string& section);
std::vector<std::string> section_names(const TrackTimes& track);  // in order of time, "" left out

}  // namespace cloudscape::bench
