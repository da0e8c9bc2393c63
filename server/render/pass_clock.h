// What each pass of a frame takes. Without a GPU each is waited for, in wall and processor time; with one timestamps
// lie between the passes, and nothing waits before `times`.
#pragma once
#include <chrono>
#include <string_view>
#include <utility>
#include <vector>

#include "core/frame.h"
#include "gpu/context.h"
#include "gpu/readback.h"

namespace cloudscape::render {

class PassClock {
 public:
  PassClock() = default;  // tells nothing, and costs nothing
  explicit PassClock(const gpu::Context& context) : context_(&context) {}
  void start();                     // what comes next is timed
  void lap(std::string_view pass);  // what came since the start or the last lap was a part of this pass
  std::vector<PassTime> times();    // of each pass, in their order; waits for the device

 private:
  using Clock = std::chrono::steady_clock;
  PassTime& pass_named(std::string_view name);

  const gpu::Context* context_ = nullptr;
  Clock::time_point at_{};
  double cpu_ms_ = 0;
  std::vector<std::pair<std::string_view, gpu::Timer>> laps_;
  std::vector<PassTime> passes_;
};

}  // namespace cloudscape::render
