#include "core/wind.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace cloudscape {
namespace {

// tuned: about as long as air rises through a cumulus; longer makes all clouds of a sheared wind lean as far as they
// can.
constexpr double cloud_age_s = 600;

// tuned, of evolution_m_per_s. The detail goes downwind as it rises, or its billows would stand like curtains; the fine
// detail goes faster by no whole number, so that the two never move as one; coverage changes within an hour, slower
// than anybody sees a cloud change and faster than the same clouds bore.
constexpr double downwind = 0.4, fine_detail = 1.7, coverage = 4;

glm::dvec2 towards(const Wind& wind) {
  const double azimuth = wind.towards_azimuth_deg * std::numbers::pi / 180;
  return {std::sin(azimuth), std::cos(azimuth)};
}

// Metres across for each metre up: that of the shear where it is little, and below 1 however much it is.
double lean_slope(const Wind& wind) {
  const double slope = wind.shear_per_s * cloud_age_s;
  return slope / std::sqrt(1 + slope * slope);
}

}  // namespace

glm::dvec2 wind_m_per_s(const Wind& wind, double altitude_m) {
  return towards(wind) * (wind.speed_m_per_s + wind.shear_per_s * altitude_m);
}

glm::dvec2 drift_m_per_s(const Cloudscape& cloudscape) {
  return wind_m_per_s(cloudscape.wind, cloudscape.volume.origin_m.z);
}

glm::dvec2 lean_m(const Cloudscape& cloudscape) {
  const Volume& volume = cloudscape.volume;
  if (volume.kind != VolumeKind::noise || !volume.tiling) return {0, 0};
  return towards(cloudscape.wind) * (lean_slope(cloudscape.wind) * volume.size_m.z);
}

double lean_stretch(const Cloudscape& cloudscape) {
  const double slope = glm::length(lean_m(cloudscape)) / cloudscape.volume.size_m.z;
  return std::sqrt(1 + slope * slope);
}

Evolution evolution(const Wind& wind, double time_s) {
  const double way_m = wind.evolution_m_per_s * time_s;
  const glm::dvec2 along = towards(wind) * way_m;
  const glm::dvec3 rise(along * downwind, way_m);
  return {rise, fine_detail * rise, coverage * along};
}

}  // namespace cloudscape
