// The wind: how fast it blows at an altitude, and how it makes clouds lean and change. World frame of core/view.h.
#pragma once
#include <glm/vec2.hpp>

#include "core/cloudscape.h"

namespace cloudscape {

// East and north, m/s.
glm::dvec2 wind_m_per_s(const Wind& wind, double altitude_m);

// The same of a layer as a whole: it drifts with the wind at its bottom. Of a document as it is marched.
glm::dvec2 drift_m_per_s(const Cloudscape& cloudscape);

// How far east and north the cloud at a layer's top stands of the cloud at its bottom, m: a cloud that grows while the
// wind above is another leans. 0 of what stands alone or comes from a file, and has its place.
glm::dvec2 lean_m(const Cloudscape& cloudscape);

// How far two points can be apart, across, before a cloud leant, for each metre that they are apart now. 1: no lean.
double lean_stretch(const Cloudscape& cloudscape);

// What changes clouds on their way: how far two scales of detail and the slow change of coverage have moved against the
// shape after `time_s`, m. x, y: east, north; z: up.
struct Evolution {
  glm::dvec3 detail_m{0}, fine_detail_m{0};
  glm::dvec2 coverage_m{0};
};
Evolution evolution(const Wind& wind, double time_s);

}  // namespace cloudscape
