// The steps of a ray's march: what bounds it, and what a picture of such rays may cost.
#pragma once
#include <algorithm>

#include "core/cloudscape_march.h"
#include "core/quality.h"

namespace cloudscape {

struct MarchSteps {
  int view = 0;   // of one view ray, at most
  int light = 0;  // towards the sun, from each of them that is in cloud
};

constexpr MarchSteps march_steps(const March& march, const RenderQuality& quality) {
  // llvmpipe ends the loops of a shader when they have gone round 65535 times in all; each step may look for cloud,
  // shade it, and march its light.
  constexpr int most_rounds = 65000;
  const int light = march.light_steps.value_or(quality.light_steps);
  return {std::min(march.max_steps.value_or(quality.max_steps), most_rounds / (light + 2)), light};
}

// Steps of both kinds that one ray may take: as many as if all of its way were thin cloud. A traced path takes about as
// many as its quality says.
constexpr double most_steps_of_ray(const March& march, const RenderQuality& quality) {
  if (quality.technique == Technique::path_tracing) return quality.max_steps;
  const MarchSteps steps = march_steps(march, quality);
  return static_cast<double>(steps.view) * (1 + (march.lighting ? steps.light : 0));
}

}  // namespace cloudscape
