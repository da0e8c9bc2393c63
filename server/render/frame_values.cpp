// The frame block: camera, sun, sky, ground and display of one sample.
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/block_values.h"

namespace cloudscape::render {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;
constexpr double largest_half = 65504,
                 largest_float = 3.4e38;   // a brighter sun would be infinite, and NaN behind a cloud
constexpr double ground_period_m = 65536;  // shaders/lib/ground.glsl

vec4 xyz_w(const glm::dvec3& xyz, double w) { return {xyz.x, xyz.y, xyz.z, w}; }

double wrapped(double value, double period) { return value - period * std::floor(value / period); }

// Offset of a sample in the pixel, -0.5..0.5: the R2 sequence (Roberts 2018), even over any number of samples.
glm::dvec2 subpixel_offset(int sample) {
  if (sample == 0) return {0, 0};
  return {wrapped(0.5 + 0.7548776662466927 * sample, 1) - 0.5, wrapped(0.5 + 0.5698402909980532 * sample, 1) - 0.5};
}

// A sea is the ground that clouds and air are lit from. The surface of water reflects 0.066 of diffuse light
// (Preisendorfer and Mobley 1986, of a calm sea).
void set_water(FrameBlock& block, const Ground& ground) {
  constexpr double no_water_m = -1e9;
  block.water = xyz_w(glm::min(ground.water.albedo + 0.066, 1.0), ground.water.level_m.value_or(no_water_m));
  if (!ground.water.level_m || ground.kind == GroundKind::terrain) return;
  block.ground.x = static_cast<float>(GroundKind::plain);
  block.ground_albedo = vec4(glm::vec3(block.water), 0);
}

}  // namespace

glm::dvec3 direction_of(double azimuth_deg, double elevation_deg) {
  const double azimuth = azimuth_deg * radians_per_degree, elevation = elevation_deg * radians_per_degree;
  return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
}

CameraAxes camera_axes(const CameraPose& pose) {
  const double azimuth = pose.azimuth_deg * radians_per_degree, roll = pose.roll_deg * radians_per_degree;
  const glm::dvec3 forward = direction_of(pose.azimuth_deg, pose.elevation_deg);
  const glm::dvec3 level(std::cos(azimuth), -std::sin(azimuth), 0);
  const glm::dvec3 upright = glm::cross(level, forward);
  return {std::cos(roll) * level - std::sin(roll) * upright, std::sin(roll) * level + std::cos(roll) * upright,
          forward};
}

FrameRequest seen_by_nobody(const std::shared_ptr<const Cloudscape>& cloudscape, const glm::dvec3& below) {
  FrameRequest request;
  request.cloudscape = cloudscape;
  request.pose.position_m = below;
  request.quality = render_quality(Quality::high);
  return request;
}

FrameBlock frame_block(const FrameRequest& request, int sample) {
  const Cloudscape& sky = *request.cloudscape;
  const CameraAxes axes = camera_axes(request.pose);
  const glm::dvec2 offset = subpixel_offset(sample);
  FrameBlock block{};
  block.camera_right = xyz_w(axes.right, 0);
  block.camera_up = xyz_w(axes.up, 0);
  block.camera_forward = xyz_w(axes.forward, request.pose.position_m.z);
  block.lens = {std::tan(0.5 * request.lens.vertical_fov_deg * radians_per_degree), request.lens.width_m, offset.x,
                offset.y};
  block.size = {request.size_px.width, request.size_px.height, static_cast<int>(request.lens.kind),
                request.quality.march_divisor};
  block.sample_info = {sample, 0, 0, request.display.dither};
  block.sky = xyz_w(sky.sky.radiance, static_cast<double>(sky.sky.kind));
  block.atmosphere = {sky.sky.rayleigh, sky.sky.haze, sky.sky.ozone, sky.sky.aerosol_scale_m};
  block.aerosol = {sky.sky.aerosol_asymmetry_g, 0, 0, 0};
  block.ground_albedo = xyz_w(sky.ground.albedo, sky.ground.variation);
  block.ground = {static_cast<int>(sky.ground.kind), wrapped(request.pose.position_m.x, ground_period_m),
                  wrapped(request.pose.position_m.y, ground_period_m), 0};
  block.display = {std::exp2(request.display.exposure_ev), static_cast<int>(request.display.tone_curve),
                   request.display.bloom_strength, request.display.bloom_threshold};
  block.accumulation = {1.0 / (sample + 1), request.quality.float32 ? largest_float : largest_half, 1,
                        request.sample_share};
  set_water(block, sky.ground);
  set_lights(block, request);
  return block;
}

}  // namespace cloudscape::render
