// What a frame of a moving picture sees that the one before it did not: beyond its edges when it turns, and behind land
// that moves.
#pragma once
#include "render/resolve_plan.h"

namespace cloudscape::render {

// Whether such pixels are marched at once, each by a ray of its own; else they begin as what lies between the frame's
// rays. `before`: nullopt if there is no picture that this one could continue.
bool marches_newly_seen(const ResolvePlan& plan, const KeptView& now, const std::optional<KeptView>& before);
// 1 / distance of the nearest that is marched so, where the camera has moved so far.
double most_newly_seen_closeness_per_m(double moved_m);

}  // namespace cloudscape::render
