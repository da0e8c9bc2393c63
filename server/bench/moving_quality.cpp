#include "bench/moving_quality.h"

#include <algorithm>
#include <cmath>

#include "bench/flip.h"
#include "bench/picture_error.h"
#include "bench/track_times.h"
#include "stream/moving_frame.h"

namespace cloudscape::bench {
namespace {

constexpr StreamId moving_stream = 1, truth_stream = 2;

// The moving stream: its next frame shows the pose.
class Flight {
 public:
  explicit Flight(const QualityRun& run) : run_(run), view_(run.view) {}

  FrameRequest at(const CameraPose& pose, double vertical_fov_deg) {
    view_.pose = pose;
    view_.lens.vertical_fov_deg = vertical_fov_deg;
    return stream::moving_request(view_, moving_stream, sequence_++,
                                  stream::moving_details.at(static_cast<std::size_t>(run_.detail)));
  }
  FrameRequest at(double time_s) {
    const settings::CameraPath::Key key = settings::key_at(run_.path, time_s);
    return at(key.pose, key.vertical_fov_deg);
  }
  void resize(ImageSize size_px) { view_.size_px = size_px; }

 private:
  const QualityRun& run_;
  stream::StreamView view_;
  std::uint64_t sequence_ = 0;
};

Picture draw_truth(const QualityRun& run, const FrameRequest& moving) {
  return shown_picture(run.draw(truth_of(moving, run.truth_samples)));
}

ComparedFrame compare(const QualityRun& run, const Frame& frame, double time_s) {
  const Picture truth = draw_truth(run, frame.request), shown = shown_picture(frame);
  return {time_s, mean_of(ldr_flip(truth, shown)), psnr_db(truth, shown)};
}

void fly_leg(const QualityRun& run, const Leg& leg, Flight& flight, MovingQuality& quality) {
  run.forget(moving_stream);
  for (int i = 0; i < leg.frames; ++i) {
    const double time_s = leg.begin_s + i * run.speed / moving_fps;
    FrameRequest request = flight.at(time_s);
    request.time_passes = true;
    const Frame frame = run.draw(request);
    add_passes(quality.passes, frame.timings.passes);
    ++quality.timed_frames;
    if ((i + 1) % compared_every == 0) quality.compared.push_back(compare(run, frame, time_s));
  }
}

// The camera turns by so much a second; 0: it stands still, and the truth with it.
FlickerFigure flicker_of(const QualityRun& run, double deg_per_s, Flight& flight,
                         const std::function<void(double)>& progress) {
  const settings::CameraPath::Key key = settings::key_at(run.path, run.flicker_at_s);
  Flicker flicker;
  flight.resize(run.flicker_size_px);
  run.forget(moving_stream);
  for (int i = -flicker_warm_up; i < run.flicker_frames; ++i) {
    CameraPose pose = key.pose;
    pose.azimuth_deg += i * deg_per_s / moving_fps;
    const Frame frame = run.draw(flight.at(pose, key.vertical_fov_deg));
    if (i < 0) continue;
    if (deg_per_s == 0)
      flicker.add(shown_picture(frame));
    else
      flicker.add(shown_picture(frame), draw_truth(run, frame.request));
    progress((i + 1.0) / run.flicker_frames);
  }
  return flicker.figure();
}

}  // namespace

std::vector<Leg> legs_of(double begin_s, double end_s, double step_s, int legs) {
  if (legs < 1 || step_s <= 0) return {};
  const double apart_s = (end_s - begin_s) / legs;
  if (apart_s <= leg_frames * step_s) return {{begin_s, std::max(1, static_cast<int>((end_s - begin_s) / step_s))}};
  std::vector<Leg> pieces;
  for (int leg = 0; leg < legs; ++leg) pieces.push_back({begin_s + leg * apart_s, leg_frames});
  return pieces;
}

MovingQuality judge_moving(const QualityRun& run) {
  MovingQuality quality;
  quality.detail = run.detail;
  Flight flight(run);
  const auto legs =
      legs_of(run.path.keys.front().time_s, run.path.keys.back().time_s, run.speed / moving_fps, run.legs);
  const double parts = static_cast<double>(legs.size()) + (run.flicker_frames > 0 ? 2 : 0);
  double done = 0;
  for (const Leg& leg : legs) {
    fly_leg(run, leg, flight, quality);
    run.progress(++done / parts);
  }
  if (run.flicker_frames > 0) {
    const auto progress = [&](double share) { run.progress((done + share) / parts); };
    quality.still = flicker_of(run, 0, flight, progress);
    ++done;
    quality.pan = flicker_of(run, pan_deg_per_s, flight, progress);
  }
  run.forget(moving_stream);
  run.forget(truth_stream);
  return quality;
}

FrameRequest truth_of(const FrameRequest& moving, int samples) {
  FrameRequest truth = moving;
  truth.stream = truth_stream;
  truth.first_sample = 0;
  truth.light_may_lag = false;
  truth.time_passes = false;
  truth.display.dither = false;
  truth.quality.reuse = truth.quality.resolution_divisor = truth.quality.march_divisor = 1;
  truth.quality.samples = samples;
  truth.quality.smooth = false;
  return truth;
}

Picture shown_picture(const Frame& frame) {
  Picture picture{frame.request.size_px, {}};
  const std::vector<std::uint8_t>& rgba = frame.display_rgba;
  picture.rgb.reserve(rgba.size() / 4);
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
    picture.rgb.push_back(glm::dvec3(rgba[i], rgba[i + 1], rgba[i + 2]) / 255.0);
  return picture;
}

void add_passes(std::vector<PassTime>& sums, const std::vector<PassTime>& passes) {
  for (const PassTime& pass : passes) {
    const auto sum = std::ranges::find(sums, pass.name, &PassTime::name);
    if (sum == sums.end())
      sums.push_back(pass);
    else
      sum->ms += pass.ms, sum->cpu_ms += pass.cpu_ms;
  }
}

}  // namespace cloudscape::bench
