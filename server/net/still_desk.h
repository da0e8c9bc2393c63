// Stills on order: who waits for which picture. Requests for one and the same picture share one render; a render that
// nobody waits for any more is cancelled.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics.h"
#include "net/http_response.h"
#include "net/limits.h"
#include "net/router.h"
#include "net/still_cache.h"
#include "settings/still_request.h"
#include "stream/frame_scheduler.h"

namespace cloudscape::net {

std::string_view media_type(ImageFormat format);

class StillDesk {
 public:
  using Ready = std::function<void(std::uint64_t waiter, Response)>;
  StillDesk(stream::FrameScheduler& scheduler, Metrics& metrics) : scheduler_(scheduler), metrics_(metrics) {}

  void on_ready(Ready ready) { ready_ = std::move(ready); }
  // A cached picture at once, a waiter's number, or a refusal (429, 503).
  Answer order(const std::string& client, const settings::StillRequest& still, const std::string& etag);
  void leave(std::uint64_t waiter);  // the client is gone or was told that it takes too long
  void deliver(StreamId still, EncodedFrame image);
  void fail(StreamId still, const std::string& message, int status = 500);
  void refuse_all(const Response& response);
  std::size_t waiting() const { return waiters_.size(); }

 private:
  struct Waiter {
    std::string client, etag;
  };
  struct Render {
    StreamId still = 0;
    std::vector<std::uint64_t> waiters;
  };
  std::size_t waiting_of(const std::string& client) const;
  std::uint64_t add_waiter(const std::string& client, const std::string& etag, Render& render);
  std::vector<std::uint64_t> finish(std::map<std::string, Render>::iterator render);
  std::map<std::string, Render>::iterator find(StreamId still);

  stream::FrameScheduler& scheduler_;
  Metrics& metrics_;
  Ready ready_;
  StillCache cache_{64 << 20};  // tuned: some hundred JPEGs, or one large EXR
  std::uint64_t last_waiter_ = 0;
  std::map<std::uint64_t, Waiter> waiters_;
  std::map<std::string, Render> renders_;  // by ETag
};

}  // namespace cloudscape::net
