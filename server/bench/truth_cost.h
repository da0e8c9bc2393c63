// What a light model costs while somebody flies, and when the sun moves.
#pragma once
#include "bench/truth_run.h"

namespace cloudscape::bench {

// `request`: of the view with the model's light; its size and quality are replaced. Frames are drawn in this order: one
// that bakes and compiles, `cost_frames` at rest, and one for each of three suns a degree higher than the one before.
TruthCost truth_cost(const TruthRun& run, const FrameRequest& request);

}  // namespace cloudscape::bench
