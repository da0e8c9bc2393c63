#include "bench/truth_cost.h"

#include "bench/frame_times.h"

namespace cloudscape::bench {
namespace {

constexpr StreamId cost_stream = 2;  // of its own size
constexpr int sun_moves = 3;

FrameRequest with_higher_sun(const FrameRequest& request, double degrees) {
  auto moved = std::make_shared<Cloudscape>(*request.cloudscape);
  moved->sun.place.time_utc.clear();  // it would put the sun back
  moved->sun.elevation_deg += moved->sun.elevation_deg > 60 ? -degrees : degrees;
  FrameRequest changed = request;
  changed.cloudscape = std::move(moved);
  return changed;
}

}  // namespace

TruthCost truth_cost(const TruthRun& run, const FrameRequest& request) {
  FrameRequest each = request;
  each.stream = cost_stream;
  each.size_px = run.cost_size_px;
  each.quality = render_quality(Quality::interactive);
  each.content = FrameContent::display;
  run.draw(each);
  std::vector<double> cpu_ms, wall_ms, moved_cpu_ms;
  for (int i = 0; i < run.cost_frames; ++i) {
    const FrameSample frame = run.draw(each);
    cpu_ms.push_back(frame.cpu_ms), wall_ms.push_back(frame.wall_ms);
  }
  for (int i = 1; i <= sun_moves; ++i) moved_cpu_ms.push_back(run.draw(with_higher_sun(each, i)).cpu_ms);
  const double resting_cpu_ms = spread_of(cpu_ms).median_ms;
  return {resting_cpu_ms, spread_of(wall_ms).median_ms, spread_of(moved_cpu_ms).median_ms - resting_cpu_ms};
}

}  // namespace cloudscape::bench
