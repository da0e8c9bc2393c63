// What other threads leave for the network thread.
#pragma once
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "net/jobs.h"
#include "net/server.h"

namespace cloudscape::net {

struct FrameArrived {
  stream::Work work;
  FrameTimings timings;
  EncodedFrame frame;
};
struct StillArrived {
  StreamId still = 0;
  EncodedFrame image;
};
struct RenderFailed {
  StreamId stream_or_still = 0;
  std::string message;
  int status = 500;
};
struct SamplesTaken {
  StreamId still = 0;
  double share = 0;
  int samples = 0;
};
using Mail = std::variant<RendererInfo, FrameArrived, StillArrived, RenderFailed, SamplesTaken, JobNews>;

// Thread-safe. Bounded by what the scheduler lets out: a few frames a stream and a job, and its queue of stills.
class Mailbox {
 public:
  void put(Mail mail) {
    const std::lock_guard lock(mutex_);
    mails_.push_back(std::move(mail));
  }
  std::vector<Mail> take_all() {
    const std::lock_guard lock(mutex_);
    return std::exchange(mails_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<Mail> mails_;
};

}  // namespace cloudscape::net
