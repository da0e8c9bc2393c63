#include "bench/track_times.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/frame_times.h"
#include "core/cpu_time.h"

namespace cloudscape::bench {
namespace {

constexpr StreamId track_stream = 1, shared_work_stream = 2;  // of their own sizes
constexpr ImageSize shared_work_size{16, 9};

FrameRequest request_at(const FrameRequest& variant, const settings::CameraPath::Key& key) {
  FrameRequest request = variant;
  request.pose = key.pose;
  request.lens = Lens{};
  request.lens.vertical_fov_deg = key.vertical_fov_deg;
  request.stream = track_stream;
  return request;
}

// The middles of `frames` equal parts of the path's time, so that no frame lies on the border of two sections.
std::vector<double> times_on(const settings::CameraPath& path, int frames) {
  const double begin_s = path.keys.front().time_s, length_s = path.keys.back().time_s - begin_s;
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) times.push_back(begin_s + length_s * (i + 0.5) / frames);
  return times;
}

TrackTimes empty_times(const settings::CameraPath& path, std::size_t variants, int frames) {
  TrackTimes track;
  track.time_s = times_on(path, frames);
  for (const double time_s : track.time_s) {
    const auto* section = settings::section_at(path, time_s);
    track.sections.push_back(section ? section->name : "");
  }
  track.variants.resize(variants);
  for (VariantTimes& times : track.variants) times.frames.resize(track.time_s.size());
  return track;
}

}  // namespace

TrackTimes run_track(const settings::CameraPath& path, const std::vector<FrameRequest>& variants, const TrackRun& run,
                     const Draw& draw) {
  TrackTimes track = empty_times(path, variants.size(), run.frames);
  track.size_px = variants.front().size_px, track.base_march = variants.front().march;
  const auto draw_all = [&](std::size_t frame) {
    const settings::CameraPath::Key key = settings::key_at(path, track.time_s[frame]);
    FrameRequest shared_work = request_at(variants.front(), key);
    shared_work.size_px = shared_work_size;
    shared_work.stream = shared_work_stream;
    draw(shared_work);
    for (std::size_t turn = 0; turn < variants.size(); ++turn) {
      const std::size_t variant = (frame + turn) % variants.size();
      track.variants[variant].frames[frame] = draw(request_at(variants[variant], key));
    }
  };
  for (int round = 0; round < run.warm_up; ++round) draw_all(0);  // measured once more below
  for (std::size_t frame = 0; frame < track.time_s.size(); ++frame) {
    draw_all(frame);
    run.progress(static_cast<double>(frame + 1) / static_cast<double>(track.time_s.size()));
  }
  return track;
}

FrameSample timed_frame(render::Renderer& renderer, const FrameRequest& request) {
  const double cpu_ms = process_cpu_ms();
  const auto start = std::chrono::steady_clock::now();
  const Frame frame = renderer.render(request);
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), frame.timings.gpu_ms, process_cpu_ms() - cpu_ms};
}

std::vector<double> times_of(const VariantTimes& variant, TimeKind kind) {
  std::vector<double> times;
  for (const FrameSample& frame : variant.frames)
    times.push_back(kind == TimeKind::wall ? frame.wall_ms : kind == TimeKind::device ? frame.device_ms : frame.cpu_ms);
  return times;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

Summary summary_of(const std::vector<double>& times_ms) {
  const Spread spread = spread_of(times_ms);
  return {mean_of(times_ms), spread.median_ms, spread.p95_ms};
}

std::vector<double> ratios_of(const std::vector<double>& times_ms, const std::vector<double>& base_ms) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(times_ms.size(), base_ms.size()); ++i)
    ratios.push_back(base_ms[i] > 0 ? times_ms[i] / base_ms[i] : 0);
  return ratios;
}

PairedRatio paired_ratio(const std::vector<double>& times_ms, const std::vector<double>& base_ms) {
  const double base_mean_ms = mean_of(base_ms);
  return {base_mean_ms > 0 ? mean_of(times_ms) / base_mean_ms : 0, spread_of(ratios_of(times_ms, base_ms)).median_ms};
}

std::vector<double> in_section(const TrackTimes& track, const std::vector<double>& values, const std::string& section) {
  std::vector<double> found;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (track.sections[i] == section) found.push_back(values[i]);
  return found;
}

std::vector<std::string> section_names(const TrackTimes& track) {
  std::vector<std::string> names;
  for (const std::string& section : track.sections)
    if (!section.empty() && std::find(names.begin(), names.end(), section) == names.end()) names.push_back(section);
  return names;
}

}  // namespace cloudscape::bench
