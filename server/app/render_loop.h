// The render thread: makes its own GPU stack, and renders for the server until the scheduler stops.
#pragma once
#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <thread>

#include "app/gpu_stack.h"
#include "net/server.h"
#include "stream/frame_scheduler.h"

namespace cloudscape::app {

class RenderLoop {
 public:
  // Starts the thread; it makes its own GPU stack, renders a first picture of `first`, and then tells `server` and
  // `on_ready`.
  RenderLoop(GpuOptions options, std::shared_ptr<const Cloudscape> first, stream::FrameScheduler& scheduler,
             net::Server& server, Metrics& metrics, std::function<void()> on_ready);
  ~RenderLoop();  // after scheduler.stop()
  // What ended the thread before its time, if anything did.
  std::exception_ptr failure() const;

 private:
  void run();
  void start(GpuStack& stack);
  void loop(GpuStack& stack);
  void tell_memory(const GpuStack& stack);

  GpuOptions options_;
  std::shared_ptr<const Cloudscape> first_;
  stream::FrameScheduler& scheduler_;
  net::Server& server_;
  Metrics& metrics_;
  std::function<void()> on_ready_;
  std::exception_ptr failure_;
  std::atomic<bool> failed_ = false;
  std::thread thread_;
};

}  // namespace cloudscape::app
