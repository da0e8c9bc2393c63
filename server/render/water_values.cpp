// The water block: how steep the waves of a wind are, and the trains of waves that a picture shows.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/block_values.h"
#include "render/water_stage.h"

namespace cloudscape::render {
namespace {

constexpr double two_pi = 2 * std::numbers::pi, gravity_m_per_s2 = 9.81;
constexpr int train_count = 24;

double fraction(double value) { return value - std::floor(value); }

struct Train {
  glm::dvec2 direction;
  double wave_number = 0;  // 1/m
  double turns = 0;        // phase at the point below the camera
};

// The waves of a wind hold as much slope in each octave of their length, from the longest that the wind has raised
// (Pierson and Moskowitz 1964) down. tuned: to 0.08 m, below which they are roughness; their directions spread from the
// wind's the more the shorter they are, and by the golden ratio, so that no two trains go alike.
Train train_of(int number, const FrameRequest& request) {
  const double share = static_cast<double>(number) / (train_count - 1), shortest_m = 0.08;
  const double scatter = fraction(0.618033988749895 * number + 0.3), shift = fraction(0.754877666246693 * number);
  const double longest_m = longest_wave_m(request.cloudscape->ground.water.wind_m_per_s);
  const double length_m = longest_m * std::pow(shortest_m / longest_m, share) * (0.85 + 0.3 * shift);
  const double side = 2 * scatter - 1, turn_deg = side * std::abs(side) * std::lerp(40.0, 90.0, share);
  const double wave_number = two_pi / length_m;
  Train train;
  train.direction = glm::dvec2(direction_of(request.cloudscape->wind.towards_azimuth_deg + turn_deg, 0));
  train.wave_number = wave_number;
  // Deep water: the square of the angular frequency is gravity times the wave number.
  const double phase = wave_number * glm::dot(train.direction, glm::dvec2(request.pose.position_m)) -
                       std::sqrt(gravity_m_per_s2 * wave_number) * request.time_s;
  train.turns = fraction(phase / two_pi + shift);
  return train;
}

mat4 trains_from(int first, const FrameRequest& request) {
  mat4 trains;
  for (int i = 0; i < 4; ++i) {
    const Train train = train_of(first + i, request);
    const glm::dvec4 column(train.direction, train.wave_number, train.turns);
    for (int row = 0; row < 4; ++row) trains[row][i] = static_cast<float>(column[row]);
  }
  return trains;
}

}  // namespace

double mean_square_slope(double wind_m_per_s) { return 0.003 * std::min(wind_m_per_s, 1.0) + 0.00512 * wind_m_per_s; }

double longest_wave_m(double wind_m_per_s) {
  const double angular_frequency = 0.855 * gravity_m_per_s2 / std::max(wind_m_per_s, 1e-3);
  const double length_m = two_pi * gravity_m_per_s2 / (angular_frequency * angular_frequency);
  return std::clamp(length_m, 2.0, 200.0);
}

WaterBlock water_block(const FrameRequest& request) {
  const Water& water = request.cloudscape->ground.water;
  const double whole = mean_square_slope(water.wind_m_per_s);
  // tuned: as Cox and Munk's sea under a film of oil, which has no ripples shorter than 0.3 m, has half of the slope.
  const double long_waves = 0.6 * whole;
  const double slope = std::sqrt(2 * long_waves / train_count);
  const glm::dvec2 width = pixel_widths(request);
  WaterBlock block{};
  block.surface = {water.level_m.value_or(0), whole - long_waves, 0, 1 / water.clarity_m};
  block.body = vec4(glm::vec3(water.albedo), slope);
  block.view = {width.x, width.y, 0, 0};
  block.clouds = {0, 0, 1, -1};
  block.waves_a = trains_from(0, request);
  block.waves_b = trains_from(4, request);
  block.waves_c = trains_from(8, request);
  block.waves_d = trains_from(12, request);
  block.waves_e = trains_from(16, request);
  block.waves_f = trains_from(20, request);
  return block;
}

}  // namespace cloudscape::render
