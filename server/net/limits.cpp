#include "net/limits.h"

#include <algorithm>

namespace cloudscape::net {

double TokenBucket::level_at(Instant now) const {
  const double elapsed_s = std::chrono::duration<double>(now - last_).count();
  return std::min(burst_, level_ + per_s_ * std::max(0.0, elapsed_s));
}

bool TokenBucket::take(Instant now) {
  level_ = level_at(now);
  last_ = now;
  if (level_ < 1) return false;
  level_ -= 1;
  return true;
}

bool TokenBucket::full(Instant now) const { return level_at(now) >= burst_; }

bool RateLimit::take(const std::string& client, Instant now) {
  // tuned: a sweep every 1024 addresses keeps the table small and its cost below one comparison a request.
  if (buckets_.size() >= 1024) forget_idle(now);
  return buckets_.try_emplace(client, per_s_, burst_).first->second.take(now);
}

void RateLimit::forget_idle(Instant now) {
  std::erase_if(buckets_, [now](const auto& entry) { return entry.second.full(now); });
}

}  // namespace cloudscape::net
