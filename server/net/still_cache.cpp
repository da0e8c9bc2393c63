#include "net/still_cache.h"

namespace cloudscape::net {

std::shared_ptr<const EncodedFrame> StillCache::find(const std::string& etag) {
  const auto found = by_etag_.find(etag);
  if (found == by_etag_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->image;
}

void StillCache::put(const std::string& etag, std::shared_ptr<const EncodedFrame> image) {
  if (by_etag_.contains(etag) || image->bytes.size() > max_bytes_) return;
  bytes_ += image->bytes.size();
  entries_.push_front({etag, std::move(image)});
  by_etag_[etag] = entries_.begin();
  while (bytes_ > max_bytes_) forget_oldest();
}

void StillCache::forget_oldest() {
  bytes_ -= entries_.back().image->bytes.size();
  by_etag_.erase(entries_.back().etag);
  entries_.pop_back();
}

}  // namespace cloudscape::net
