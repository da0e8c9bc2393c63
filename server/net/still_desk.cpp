#include "net/still_desk.h"

#include <algorithm>

#include "net/metric_names.h"
#include "net/problem.h"

namespace cloudscape::net {
namespace {

// tuned: one client keeps the renderer busy while another's still waits behind at most four.
constexpr std::size_t max_stills_of_client = 4;
constexpr int retry_after_s = 2;  // tuned: about one still at standard quality on two cores

Response picture(const std::shared_ptr<const EncodedFrame>& image, const std::string& etag) {
  Response response{200, std::string(media_type(image->format)), {}, Body::of(image), false};
  return response.with("etag", etag).with("cache-control", "private, no-cache");
}

}  // namespace

std::string_view media_type(ImageFormat format) {
  // OpenEXR has no registered type; image/x-exr is what ImageMagick and browsers' file managers use.
  constexpr std::string_view types[] = {"image/jpeg", "image/png", "image/x-exr"};
  return types[static_cast<std::size_t>(format)];
}

Answer StillDesk::order(const std::string& client, const settings::StillRequest& still, const std::string& etag) {
  if (const auto cached = cache_.find(etag)) {
    metrics_.count(metric::still_cache_hits);
    metrics_.count(metric::stills_sent);
    return picture(cached, etag);
  }
  if (waiting_of(client) >= max_stills_of_client) {
    metrics_.count(metric::refused("rate"));
    return busy(429, "This client waits for 4 stills already: ask again when one has arrived.", retry_after_s);
  }
  if (const auto same = renders_.find(etag); same != renders_.end())
    return Pending{add_waiter(client, etag, same->second)};
  const std::optional<StreamId> id = scheduler_.submit_still(still.frame, still.encoding);
  if (!id) {
    metrics_.count(metric::refused("queue"));
    return busy(503, "The queue of stills is full: ask again later.", retry_after_s);
  }
  return Pending{add_waiter(client, etag, renders_[etag] = {*id, {}})};
}

std::size_t StillDesk::waiting_of(const std::string& client) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(waiters_, [&](const auto& entry) { return entry.second.client == client; }));
}

std::uint64_t StillDesk::add_waiter(const std::string& client, const std::string& etag, Render& render) {
  waiters_[++last_waiter_] = {client, etag};
  render.waiters.push_back(last_waiter_);
  return last_waiter_;
}

void StillDesk::leave(std::uint64_t waiter) {
  const auto found = waiters_.find(waiter);
  if (found == waiters_.end()) return;
  const auto render = renders_.find(found->second.etag);
  waiters_.erase(found);
  if (render == renders_.end()) return;
  std::erase(render->second.waiters, waiter);
  if (!render->second.waiters.empty()) return;
  scheduler_.cancel_still(render->second.still);
  renders_.erase(render);
}

void StillDesk::deliver(StreamId still, EncodedFrame image) {
  const auto render = find(still);
  if (render == renders_.end()) return;
  const std::string etag = render->first;
  const auto shared = std::make_shared<const EncodedFrame>(std::move(image));
  cache_.put(etag, shared);
  metrics_.set(metric::still_cache_bytes, static_cast<double>(cache_.bytes()));
  for (const std::uint64_t waiter : finish(render)) {
    metrics_.count(metric::stills_sent);
    ready_(waiter, picture(shared, etag));
  }
}

void StillDesk::fail(StreamId still, const std::string& message, int status) {
  const auto render = find(still);
  if (render == renders_.end()) return;
  for (const std::uint64_t waiter : finish(render))
    ready_(waiter, problem(status, "The still could not be rendered: " + message));
}

void StillDesk::refuse_all(const Response& response) {
  while (!renders_.empty()) {
    scheduler_.cancel_still(renders_.begin()->second.still);
    for (const std::uint64_t waiter : finish(renders_.begin())) ready_(waiter, response);
  }
}

std::map<std::string, StillDesk::Render>::iterator StillDesk::find(StreamId still) {
  return std::ranges::find_if(renders_, [still](const auto& entry) { return entry.second.still == still; });
}

std::vector<std::uint64_t> StillDesk::finish(std::map<std::string, Render>::iterator render) {
  std::vector<std::uint64_t> waiters = std::move(render->second.waiters);
  renders_.erase(render);
  for (const std::uint64_t waiter : waiters) waiters_.erase(waiter);
  return waiters;
}

}  // namespace cloudscape::net
