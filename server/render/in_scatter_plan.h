// Where the points of a document's in-scatter volume lie.
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "bake/baked_cloudscape.h"
#include "core/cloudscape.h"
#include "render/blocks.h"

namespace cloudscape::render {

// A place is 0..1 across the volume's box: east, north, up. `thresholds`: of the levels, ascending: where coverage
// varies over the land the light is solved for some thresholds, as if each were the same everywhere.
struct InScatterPlan {
  glm::ivec3 size{1};
  glm::dvec3 first{0}, spacing{1};  // places
  bool periodic = true;
  std::vector<double> thresholds{0};
};

// `lowest`, `highest`: altitudes between which there is cloud, as a place. `marched`: as `as_marched` makes it.
InScatterPlan in_scatter_plan(const Cloudscape& marched, double lowest, double highest, double threshold, double swing);

// Mean cosine of the document's phase function; of mie `mie_asymmetry_g`.
double mean_cosine(const Phase& phase, double mie_asymmetry_g);

void set_in_scatter(CloudBlock& block, const InScatterPlan& plan);
// Of a block that has its medium, whose phase function has this mean cosine.
void set_mean_cosine(CloudBlock& block, double mean_cosine);

}  // namespace cloudscape::render
