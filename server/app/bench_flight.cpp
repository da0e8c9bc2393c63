#include "app/bench_flight.h"

#include <glm/glm.hpp>

#include "core/cpu_time.h"
#include "core/error.h"
#include "core/milliseconds.h"
#include "stream/moving_frame.h"

namespace cloudscape::app {
namespace {

using Clock = std::chrono::steady_clock;

// tuned: how long the render thread sleeps at most while no viewer wants a frame.
constexpr auto idle_wait = std::chrono::milliseconds(5);

// Returns how long no viewer wanted anything.
Clock::duration pump_until(FramePump& pump, const SimulatedViewers& viewers, auto&& done) {
  Clock::duration idle{};
  while (!done()) {
    const Clock::time_point start = Clock::now();
    if (!pump.step(start + idle_wait)) idle += Clock::now() - start;
    if (const std::string failure = viewers.failure(); !failure.empty())
      throw Error("a frame could not be rendered: " + failure);
  }
  return idle;
}

// From where the first viewer begins, at several coarsenesses, since each may need shaders of its own.
void draw_first(GpuStack& stack, const settings::CameraPath& path, const SimulatedViewers::Viewer& viewer) {
  const StreamId before_all = 0;
  stream::StreamView view = viewer.view;
  view.pose = settings::at(path, viewer.start_s);
  std::uint64_t sequence = 0;
  for (const stream::MovingDetail& detail : stream::moving_details) {
    stack.renderer.render(stream::moving_request(view, before_all, sequence++, detail));
    view.pose.azimuth_deg += 0.3;  // what is newly seen is marched by passes of its own
  }
  stack.renderer.forget(before_all);
}

// tuned: a view's march begins fine and gives way after two slow frames each time; a slow machine takes longer for so
// many frames than the warm-up lasts, but not without end.
bool settled(const SimulatedViewers& viewers, double warm_up_s, std::size_t streams) {
  constexpr std::size_t frames = 10;
  constexpr double most_warm_ups = 10;
  const double seconds = viewers.seconds();
  return seconds >= most_warm_ups * warm_up_s || (seconds >= warm_up_s && viewers.delivered() >= frames * streams);
}

Flown measure(GpuStack& stack, const FlightPlan& plan, FramePump& pump, SimulatedViewers& viewers) {
  viewers.measure_from_now();
  const double cpu_ms = process_cpu_ms();
  const bench::ThreadTimes threads = bench::thread_cpu_ms();
  const int sky_bakes = stack.renderer.sky_bakes();
  const auto idle = pump_until(pump, viewers, [&] {
    return viewers.seconds() >= plan.seconds ||
           (plan.frames > 0 && viewers.delivered() >= static_cast<std::size_t>(plan.frames));
  });
  Flown flown;
  flown.seconds = viewers.seconds();
  flown.frames = viewers.frames();
  flown.busy_share = 1 - milliseconds(idle) / (1000 * flown.seconds);
  flown.cpu_ms = process_cpu_ms() - cpu_ms;
  flown.threads = bench::since(threads, bench::thread_cpu_ms());
  flown.history_bytes = stack.renderer.history_bytes();
  flown.sky_bakes = stack.renderer.sky_bakes() - sky_bakes;
  return flown;
}

}  // namespace

Flown fly(GpuStack& stack, const FlightPlan& plan, const std::vector<SimulatedViewers::Viewer>& viewers) {
  draw_first(stack, plan.viewers.path, viewers.front());
  Metrics metrics;
  stream::SchedulerOptions options;
  options.target_frame_ms = 1000 / plan.target_fps;
  stream::FrameScheduler scheduler(options, metrics);
  Flown flown;
  {
    SimulatedViewers simulated(scheduler, plan.viewers, viewers);
    FramePump pump(scheduler, stack.renderer, simulated.sink());
    pump_until(pump, simulated, [&] { return settled(simulated, plan.warm_up_s, viewers.size()); });
    flown = measure(stack, plan, pump, simulated);
  }
  for (const StreamId stream : stack.renderer.remembered()) stack.renderer.forget(stream);
  return flown;
}

stream::StreamView view_of(const std::shared_ptr<const Cloudscape>& cloudscape, ImageSize size) {
  stream::StreamView view;
  view.cloudscape = cloudscape;
  view.pose = cloudscape->view.pose;
  view.lens = cloudscape->view.lens;
  view.display = cloudscape->view.display;
  view.march = cloudscape->view.march;
  view.size_px = size;
  return view;
}

double length_s(const settings::CameraPath& path) { return path.keys.back().time_s - path.keys.front().time_s; }

double mean_speed_m_per_s(const settings::CameraPath& path, double speed) {
  constexpr double step_s = 0.1;
  double length_m = 0;
  for (double time_s = path.keys.front().time_s; time_s < path.keys.back().time_s; time_s += step_s)
    length_m += glm::distance(settings::at(path, time_s).position_m, settings::at(path, time_s + step_s).position_m);
  return length_s(path) > 0 ? speed * length_m / length_s(path) : 0;
}

}  // namespace cloudscape::app
