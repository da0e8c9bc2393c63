#include "render/trace_plan.h"

#include <algorithm>

namespace cloudscape::render {
namespace {

// An error of few samples is not known well: a wave at most doubles them.
int toward_the_noise_target(double target, const TraceStand& stand) {
  constexpr int first = 4;
  if (stand.samples < first) return first - stand.samples;
  if (stand.relative_error <= target) return 0;
  const double ratio = stand.relative_error / target;
  const double missing = stand.samples * (ratio * ratio - 1);
  return static_cast<int>(std::clamp(missing + 1, 1.0, 1.0 * stand.samples));
}

// The first wave is one sample, to learn what one takes; others use half of what is left, so that the last ends in
// time.
int within_the_budget(double budget_s, const TraceStand& stand) {
  if (stand.samples == 0) return 1;
  const double left = (budget_s - stand.seconds) * stand.samples / std::max(stand.seconds, 1e-6);
  return left < 1 ? 0 : static_cast<int>(std::max(1.0, std::min(0.5 * left, 1e6)));
}

}  // namespace

int next_wave(const TraceGoal& goal, const TraceStand& stand) {
  int samples = goal.samples - stand.samples;
  if (goal.noise_target) samples = std::min(samples, toward_the_noise_target(*goal.noise_target, stand));
  if (goal.time_budget_s) samples = std::min(samples, within_the_budget(*goal.time_budget_s, stand));
  return std::max(0, samples);
}

}  // namespace cloudscape::render
