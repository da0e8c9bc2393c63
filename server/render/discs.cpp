#include "render/discs.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace cloudscape::render {
namespace {

constexpr double least_radius_px = 1.2;  // every place of a picture is so close to the middles of four to six pixels

// In the middle of the picture.
double pixel_radians(double vertical_fov_deg, int rows) { return 2 * half_height_of(vertical_fov_deg) / rows; }

glm::dvec3 disc_px(const KeptView& now, ImageSize kept, const glm::dvec3& direction, double radius_deg) {
  const CameraAxes axes = camera_axes(now.pose);
  const double half = half_height_of(now.vertical_fov_deg), ahead = glm::dot(direction, axes.forward);
  if (ahead <= 0) return glm::dvec3(0);
  const glm::dvec2 size(kept.width, kept.height);
  const glm::dvec2 across(glm::dot(direction, axes.right) / now.aspect, -glm::dot(direction, axes.up));
  const glm::dvec2 at = (0.5 + 0.5 * across / (ahead * half)) * size;
  // Larger towards the picture's corners, and not beyond them.
  const double corner = 1 / (1 + half * half * (1 + now.aspect * now.aspect)),
               larger = 1 / std::max(ahead * ahead, corner);
  const double radius_px = glm::radians(radius_deg) / pixel_radians(now.vertical_fov_deg, kept.height);
  const double radius = std::max(radius_px * larger, least_radius_px);
  const bool seen = at.x > -radius && at.y > -radius && at.x < size.x + radius && at.y < size.y + radius;
  return {at, seen ? radius : 0};
}

}  // namespace

Discs discs_of(const KeptView& now, ImageSize kept) {
  const Cloudscape& sky = *now.cloudscape;
  Discs discs;
  if (sky.sun.disc)
    discs.sun_px =
        disc_px(now, kept, direction_of(sky.sun.azimuth_deg, sky.sun.elevation_deg), sky.sun.angular_radius_deg);
  if (sky.sky.kind == SkyKind::clear && sky.moon.brightness > 0)
    discs.moon_px =
        disc_px(now, kept, direction_of(sky.moon.azimuth_deg, sky.moon.elevation_deg), sky.moon.angular_radius_deg);
  return discs;
}

void widen_discs(FrameBlock& block, ImageSize kept, double vertical_fov_deg) {
  const double least = least_radius_px * pixel_radians(vertical_fov_deg, kept.height);
  const auto least_squared = static_cast<float>(least * least);
  const float sun = std::max(1.0F, least_squared / block.sun_direction.w);
  block.sun_direction.w *= sun;
  block.sun_irradiance.w /= sun;
  if (block.moon_direction.w <= 0) return;
  const float moon = std::max(1.0F, least_squared / block.moon_direction.w);
  block.moon_direction.w *= moon;
  block.moon_radiance /= moon;
}

}  // namespace cloudscape::render
