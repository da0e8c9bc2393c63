#include "render/pass_clock.h"

#include <algorithm>

#include "core/cpu_time.h"
#include "core/milliseconds.h"

namespace cloudscape::render {

void PassClock::start() {
  if (!context_) return;
  if (!context_->device().software) return laps_.emplace_back().second.start();
  context_->finish();
  at_ = Clock::now();
  cpu_ms_ = process_cpu_ms();
}

void PassClock::lap(std::string_view pass) {
  if (!context_) return;
  if (!context_->device().software) {
    laps_.back().first = pass;
    laps_.back().second.stop();
    return start();
  }
  context_->finish();
  PassTime& time = pass_named(pass);
  time.ms += ms_since(at_);
  time.cpu_ms += process_cpu_ms() - cpu_ms_;
  start();
}

PassTime& PassClock::pass_named(std::string_view name) {
  const auto found = std::ranges::find(passes_, name, &PassTime::name);
  return found == passes_.end() ? passes_.emplace_back(std::string(name)) : *found;
}

std::vector<PassTime> PassClock::times() {
  for (const auto& [pass, timer] : laps_)
    if (!pass.empty()) pass_named(pass).ms += timer.milliseconds();
  laps_.clear();
  return std::exchange(passes_, {});
}

}  // namespace cloudscape::render
