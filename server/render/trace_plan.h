// How many samples of each pixel a path-traced picture gets: in waves, between which it is decided whether another one
// begins. Within a wave every pixel gets as many samples as every other, each to its end, so that no pixel is stopped
// when its paths happen to be short.
#pragma once
#include <optional>

namespace cloudscape::render {

struct TraceGoal {
  int samples = 1;                           // of each pixel, at most
  std::optional<double> time_budget_s = {};  // no wave begins that would end later
  std::optional<double> noise_target = {};   // relative standard error of the picture that is enough
};

struct TraceStand {
  int samples = 0;            // of each pixel so far
  double seconds = 0;         // that they took
  double relative_error = 0;  // of the picture; 0: not known
};

// Samples of the next wave; 0: the picture is done.
int next_wave(const TraceGoal& goal, const TraceStand& stand);

}  // namespace cloudscape::render
