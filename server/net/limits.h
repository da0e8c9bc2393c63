// How much one client may ask for.
#pragma once
#include <chrono>
#include <map>
#include <string>

namespace cloudscape::net {

using Instant = std::chrono::steady_clock::time_point;

// Refills at `per_s` up to `burst`; each take costs one.
class TokenBucket {
 public:
  TokenBucket(double per_s, double burst) : per_s_(per_s), burst_(burst), level_(burst) {}
  bool take(Instant now);
  bool full(Instant now) const;

 private:
  double level_at(Instant now) const;
  double per_s_, burst_, level_;
  Instant last_{};
};

// One bucket an address. Addresses whose bucket is full again are forgotten, so that memory follows use.
class RateLimit {
 public:
  RateLimit(double per_s, double burst) : per_s_(per_s), burst_(burst) {}
  bool take(const std::string& client, Instant now);
  std::size_t clients() const { return buckets_.size(); }

 private:
  void forget_idle(Instant now);
  double per_s_, burst_;
  std::map<std::string, TokenBucket> buckets_;
};

}  // namespace cloudscape::net
