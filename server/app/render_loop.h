// The render thread: takes work from the scheduler, renders it slice by slice, and hands frames to the encoders.
#pragma once
#include <atomic>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "app/encode_pool.h"
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
  struct Active {
    stream::Work work;
    std::unique_ptr<render::RenderJob> job;
    double queue_ms = 0;                           // from wanted until taken
    std::chrono::steady_clock::time_point told{};  // when last how far it is
  };
  struct Pending {
    stream::Work work;
    render::PendingFrame frame;
  };
  void run();
  void start(GpuStack& stack);
  void loop(GpuStack& stack);
  void advance(GpuStack& stack, const stream::Work& work);
  Active& active_of(GpuStack& stack, const stream::Work& work);
  void tell_progress(Active& active);
  void collect(GpuStack& stack);
  void encode(const stream::Work& work, Frame frame);
  void fail(GpuStack& stack, const stream::Work& work, const std::string& message, int status = 500);
  void drop(GpuStack& stack, StreamId stream);
  void drop_the_gone(GpuStack& stack);

  GpuOptions options_;
  std::shared_ptr<const Cloudscape> first_;
  stream::FrameScheduler& scheduler_;
  net::Server& server_;
  Metrics& metrics_;
  std::function<void()> on_ready_;
  std::map<StreamId, Active> active_;
  std::optional<Pending> pending_;
  EncodePool encoders_;
  std::exception_ptr failure_;
  std::atomic<bool> failed_ = false;
  std::thread thread_;
};

}  // namespace cloudscape::app
