// Simulated viewers in flight through the program's own path: scheduler, renderer, read back, encoder, acknowledgement.
#pragma once
#include <vector>

#include "app/gpu_stack.h"
#include "app/simulated_viewers.h"
#include "bench/thread_times.h"

namespace cloudscape::app {

struct FlightPlan {
  ViewersOptions viewers;
  double target_fps = 30;
  double warm_up_s = 3;  // at least, until some frames of each have arrived; at most ten times as long
  double seconds = 10;   // measured, or until so many frames have arrived, whichever is first
  int frames = 0;        // 0: no matter how many
};

struct Flown {
  std::vector<std::vector<bench::FlownFrame>> frames;  // of each viewer
  double seconds = 0;
  double busy_share = 0;  // of the time that the render thread was at work or waited for the device
  double cpu_ms = 0;      // of the process
  bench::ThreadTimes threads;
  std::size_t history_bytes = 0;  // of all viewers
  int sky_bakes = 0;              // tables of the sky that were computed meanwhile
};

// First frames, which bake and compile, are drawn before the viewers open. Throws Error if a frame fails.
Flown fly(GpuStack& stack, const FlightPlan& plan, const std::vector<SimulatedViewers::Viewer>& viewers);

// What a viewer of the document sees with: the document's lens, display and march.
stream::StreamView view_of(const std::shared_ptr<const Cloudscape>& cloudscape, ImageSize size);
double mean_speed_m_per_s(const settings::CameraPath& path, double speed);
double length_s(const settings::CameraPath& path);

}  // namespace cloudscape::app
