// The frame block's lights: sun, moon and stars, and which of the first two lights the clouds.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/sun_position.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

vec4 xyz_w(const glm::dvec3& xyz, double w) { return {xyz.x, xyz.y, xyz.z, w}; }

double squared_chord(double angle_deg) {
  const double half_chord = std::sin(0.5 * angle_deg * radians_per_degree);
  return 4 * half_chord * half_chord;
}

// The solid angle of a disc is pi times the square of its radius' chord.
double solid_angle(double angular_radius_deg) { return std::numbers::pi * squared_chord(angular_radius_deg); }

constexpr double sun_magnitude = -26.74;  // apparent, V; Willmer 2018

// Irradiance of an object in that of the sun.
double of_the_sun(double magnitude) { return std::pow(10, -0.4 * (magnitude - sun_magnitude)); }

// Unit vector from the moon towards the sun.
glm::dvec3 moon_lit_from(const Cloudscape& sky) {
  const glm::dvec3 moon = direction_of(sky.moon.azimuth_deg, sky.moon.elevation_deg);
  const glm::dvec3 sun = direction_of(sky.sun.azimuth_deg, sky.sun.elevation_deg);
  if (!sky.moon.phase_angle_deg) return sun;
  glm::dvec3 across = sun - glm::dot(sun, moon) * moon;
  if (glm::length(across) < 1e-6) across = glm::cross(moon, glm::dvec3(0, 1, 0));
  const double angle = *sky.moon.phase_angle_deg * radians_per_degree;
  return -std::cos(angle) * moon + std::sin(angle) * glm::normalize(across);
}

// The moon's irradiance in that of the sun (Allen 1973, "Astrophysical Quantities", section 66).
double moon_of_sun(double phase_angle_deg) {
  return of_the_sun(-12.73 + 0.026 * phase_angle_deg + 4e-9 * std::pow(phase_angle_deg, 4));
}

// tuned: at these elevations of the sun the moon begins to light the clouds, is all of it, and the sun's twilight is
// over. At -5 degrees the planet's shadow reaches 24 km up, above every cloud.
constexpr double moon_begins_deg = -5, moon_whole_deg = -8, twilight_ends_deg = -20;

struct Light {
  glm::dvec3 direction{0, 0, -1}, irradiance{0};
  double radius = 0;
};

Light sun_of(const Cloudscape& sky) {
  return {direction_of(sky.sun.azimuth_deg, sky.sun.elevation_deg), sky.sun.irradiance,
          sky.sun.angular_radius_deg * radians_per_degree};
}

void set_moon(FrameBlock& block, const Cloudscape& sky, Light& light) {
  const Moon& moon = sky.moon;
  light.direction = direction_of(moon.azimuth_deg, moon.elevation_deg);
  light.radius = moon.angular_radius_deg * radians_per_degree;
  const glm::dvec3 lit_from = moon_lit_from(sky);
  const double cosine = std::clamp(-glm::dot(lit_from, light.direction), -1.0, 1.0);
  // Its rock is a little red (Velikodsky and others 2011): 3 % to either side of green.
  light.irradiance = sky.sun.irradiance * glm::dvec3(1.03, 1, 0.95) *
                     (moon.brightness * moon_of_sun(std::acos(cosine) / radians_per_degree));
  const double lit_share = std::max(0.5 * (1 + cosine), 0.01);
  block.moon_direction =
      xyz_w(light.direction,
            sky.sky.kind == SkyKind::clear && moon.brightness > 0 ? squared_chord(moon.angular_radius_deg) : 0);
  block.moon_lit_from = xyz_w(lit_from, 0);
  block.moon_radiance = xyz_w(light.irradiance / (solid_angle(moon.angular_radius_deg) * lit_share), 0);
}

// Width of what a sample stands for in the middle of the picture, radians.
double pixel_angle(const FrameRequest& request) {
  const double height = request.size_px.height / request.sample_share;
  const double smaller = std::min(request.size_px.width, request.size_px.height) / request.sample_share;
  switch (request.lens.kind) {
    case LensKind::perspective:
      return 2 * std::tan(0.5 * request.lens.vertical_fov_deg * radians_per_degree) / height;
    case LensKind::orthographic:
      return 0.001;  // it has one direction
    case LensKind::panorama:
      return std::numbers::pi / height;
    case LensKind::fisheye:
      return std::numbers::pi / smaller;
  }
  return 0.001;
}

void set_stars(FrameBlock& block, const FrameRequest& request) {
  const Cloudscape& sky = *request.cloudscape;
  const bool seen = sky.sky.kind == SkyKind::clear && sky.sky.stars > 0 && sky.sun.elevation_deg < -1;
  const Place& place = sky.sun.place;
  std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  if (const auto day = julian_day_at(place, request.time_s))
    axes = star_axes(*day, place.latitude_deg, place.longitude_deg);
  block.sample_info.y = seen ? 2 : 0;
  // tuned: six tenths of a pixel is as sharp as a picture can be without blinking.
  block.star_x = xyz_w(axes[0], std::max(0.6 * pixel_angle(request), 1e-5));
  block.star_y = xyz_w(axes[1], 0), block.star_z = xyz_w(axes[2], 0);
  block.stars = xyz_w(sky.sun.irradiance * (sky.sky.stars * of_the_sun(0)), 0);
  // The night sky at a dark place: 21.8 magnitudes a square arc second (Patat 2003), a little green and red.
  constexpr double arc_seconds_per_steradian = 4.2545e10;
  const double glow = seen ? of_the_sun(21.8) * arc_seconds_per_steradian * sky.sky.stars : 0.0;
  block.night = xyz_w(sky.sun.irradiance * glm::dvec3(1.0, 1.0, 0.9) * glow, 0);
}

// A power of two that keeps the light of twilight and night where 16 bits are precise.
double target_scale(const FrameRequest& request) {
  const Cloudscape& sky = *request.cloudscape;
  if (request.quality.float32 || sky.sky.kind != SkyKind::clear) return 1;
  return std::exp2(std::floor(std::clamp(-1.4 * (sky.sun.elevation_deg + 2), 0.0, 14.0)));
}

}  // namespace

void set_lights(FrameBlock& block, const FrameRequest& request) {
  const Cloudscape& sky = *request.cloudscape;
  const double sun_deg = sky.sun.elevation_deg;
  Light main = sun_of(sky), second, moon;
  block.sun_direction = xyz_w(main.direction, squared_chord(sky.sun.angular_radius_deg));
  block.sun_irradiance = xyz_w(main.irradiance, sky.sun.disc ? 1 / solid_angle(sky.sun.angular_radius_deg) : 0);
  set_moon(block, sky, moon);
  int lights = 1;
  if (moon_lights(sky)) {
    moon.irradiance *= std::clamp((moon_begins_deg - sun_deg) / (moon_begins_deg - moon_whole_deg), 0.0, 1.0);
    second = main, main = moon;
    lights = sun_deg > twilight_ends_deg ? 2 : 1;
  }
  block.light_direction = xyz_w(main.direction, main.radius);
  block.light_irradiance = xyz_w(main.irradiance, 0);
  block.second_direction = xyz_w(second.direction, second.radius);
  block.second_irradiance = xyz_w(second.irradiance, 0);
  block.sample_info.z = lights;
  set_stars(block, request);
  block.accumulation.z = static_cast<float>(target_scale(request));
}

bool moon_lights(const Cloudscape& sky) {
  return sky.sky.kind == SkyKind::clear && sky.sun.elevation_deg < moon_begins_deg && sky.moon.brightness > 0 &&
         sky.moon.elevation_deg > -2;
}

glm::dvec3 direction_of_light(const Cloudscape& sky) {
  return moon_lights(sky) ? direction_of(sky.moon.azimuth_deg, sky.moon.elevation_deg)
                          : direction_of(sky.sun.azimuth_deg, sky.sun.elevation_deg);
}

double light_azimuth_deg(const Cloudscape& sky) {
  return moon_lights(sky) ? sky.moon.azimuth_deg : sky.sun.azimuth_deg;
}

}  // namespace cloudscape::render
