// How long to wait before the next attempt to connect.
#pragma once
#include <functional>

namespace cloudscape::viewer {

// Exponential with full jitter (Brooker, "Exponential Backoff And Jitter", AWS 2015): clients that lost one server come
// back spread over time instead of all at once.
class BackOff {
 public:
  // `uniform` gives numbers in [0, 1).
  explicit BackOff(std::function<double()> uniform);
  double next_s();  // within [least_s, min(most_s, first_s * 2^n))
  void reset() { attempts_ = 0; }

  static constexpr double least_s = 0.1, first_s = 0.5, most_s = 10.0;  // tuned: a restart is noticed soon, no herd

 private:
  std::function<double()> uniform_;
  int attempts_ = 0;
};

std::function<double()> random_uniform();

}  // namespace cloudscape::viewer
