// From the scheduler's work to encoded frames: renders slice by slice, and hands what is rendered to the encoders. All
// on the thread of the renderer's context.
#pragma once
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/encode_pool.h"
#include "render/renderer.h"
#include "stream/frame_scheduler.h"

namespace cloudscape::app {

class FramePump {
 public:
  // What becomes of frames. The encoders' threads call `deliver`, after scheduler.encoded, and `fail`; the pump's own
  // thread calls `fail` and `tell_samples`.
  struct Sink {
    std::size_t front = 0;  // room for headers in front of a stream's frames
    std::function<void(const stream::Work&, const FrameTimings&, EncodedFrame)> deliver;
    std::function<void(StreamId, const std::string& message, int status)> fail;
    std::function<void(StreamId, double share, int samples)> tell_samples;
  };
  FramePump(stream::FrameScheduler& scheduler, render::Renderer& renderer, Sink sink);
  ~FramePump();  // finishes what the encoders were given

  // Renders a slice of what is next, if there is work before `deadline`, and hands over what is ready: false, there was
  // nothing to do.
  bool step(stream::Time deadline);
  // Forgets streams that were closed and stills that were cancelled.
  void drop_the_gone();

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
  void advance(const stream::Work& work);
  Active& active_of(const stream::Work& work);
  void tell_progress(Active& active);
  void collect_oldest();
  void collect_ready();
  void encode(const stream::Work& work, Frame frame);
  void fail(const stream::Work& work, const std::string& message, int status = 500);
  void drop(StreamId stream);

  stream::FrameScheduler& scheduler_;
  render::Renderer& renderer_;
  const Sink sink_;
  std::map<StreamId, Active> active_;
  std::deque<Pending> pending_;  // on their way back from the device, oldest first; each of another stream
  EncodePool encoders_;
};

}  // namespace cloudscape::app
