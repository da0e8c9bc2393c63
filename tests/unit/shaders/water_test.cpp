// The surface of water against Fresnel's formulas and against integrals over its slopes.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::add_waves, glsl::Footprint, glsl::mat4, glsl::vec2, glsl::vec3, glsl::vec4, glsl::Waves;
using glsl::water_fresnel, glsl::water_glitter, glsl::water_mirror, glsl::slope_density;

constexpr long double half_turn = 3.141592653589793238L;
double radians(double degrees) { return degrees * double(half_turn) / 180; }
vec3 up() { return {0, 0, 1}; }
vec3 at(double elevation_deg, double azimuth = 0) {
  const double side = std::cos(radians(elevation_deg));
  return {side * std::sin(azimuth), side * std::cos(azimuth), std::sin(radians(elevation_deg))};
}

// By the angles of incidence and refraction, of the two polarizations.
TEST(WaterFresnel, MeetsTheFormulas) {
  for (double degrees = 1; degrees < 90; degrees += 1) {
    const double in = radians(degrees), out = std::asin(std::sin(in) / 1.333L);
    const double across = std::pow(std::sin(in - out) / std::sin(in + out), 2);
    const double along = std::pow(std::tan(in - out) / std::tan(in + out), 2);
    EXPECT_NEAR(water_fresnel(float(std::cos(in))), 0.5L * (across + along), 2e-5L) << degrees;
  }
  EXPECT_NEAR(water_fresnel(1), std::pow(0.333L / 2.333L, 2), 1e-6L);
  EXPECT_NEAR(water_fresnel(0), 1, 1e-6L);
}

// server/render/frame_values.cpp takes the sea's albedo from it.
TEST(WaterFresnel, OfDiffuseLightIsAFifteenth) {
  const auto weighted = [](long double cosine) { return 2 * cosine * water_fresnel(float(cosine)); };
  EXPECT_NEAR(double(integral(weighted, 0, 1, 2000)), 0.066L, 0.001L);
}

TEST(WaterSlopes, AddUpToOneAndToTheirMeanSquare) {
  for (const float mss : {0.002F, 0.03F, 0.1F}) {
    const auto ring = [&](long double slope) {
      return 2 * half_turn * slope * slope_density(float(slope * slope), mss);
    };
    const auto square = [&](long double slope) { return slope * slope * ring(slope); };
    EXPECT_NEAR(double(integral(ring, 0, 3, 2000)), 1, 1e-3L);
    EXPECT_NEAR(double(integral(square, 0, 3, 2000)) / mss, 1, 1e-3L);
  }
}

// What all facets reflect of a beam into all directions, as a share of what arrives on level water.
double reflected_share(double sun_deg, float mss) {
  const vec3 light = at(sun_deg);
  const auto row = [&](long double cosine) {
    const auto around = [&](long double azimuth) {
      const double side = std::sqrt(1 - double(cosine * cosine));
      const vec3 view(side * std::sin(double(azimuth)), side * std::cos(double(azimuth)), double(cosine));
      return cosine * water_glitter(view, light, up(), mss);
    };
    return integral(around, 0, 2 * half_turn, 180);
  };
  return double(integral(row, 1e-4L, 1, 180)) / light.z;
}

TEST(WaterGlitter, OfNearlyFlatWaterIsWhatFresnelReflects) {
  for (const double sun_deg : {80.0, 45.0, 25.0})
    EXPECT_NEAR(reflected_share(sun_deg, 0.002F) / water_fresnel(at(sun_deg).z), 1, 0.03L) << sun_deg;
}

// Light may go to and fro between camera and sun: what the glitter sends out of a beam is what a camera there sees of a
// white sky. In a low sun it is less, for some of what is reflected twice goes into the water.
TEST(WaterGlitter, SendsOutWhatTheFacetsReflect) {
  for (const float mss : {0.01F, 0.035F})
    for (const double sun_deg : {60.0, 30.0, 15.0, 8.0}) {
      const double mirrored = water_mirror(at(sun_deg), up(), mss).share;
      const double ratio = reflected_share(sun_deg, mss) / mirrored;
      EXPECT_NEAR(ratio, 1, sun_deg < 20 ? 0.17L : 0.04L) << sun_deg << ", " << mss;
    }
}

TEST(WaterGlitter, IsTheSameWithCameraAndSunExchanged) {
  const vec3 a = at(20), b = at(35, 2.6L);
  EXPECT_NEAR(water_glitter(a, b, up(), 0.05F) * a.z / (water_glitter(b, a, up(), 0.05F) * b.z), 1, 1e-4L);
}

TEST(WaterMirror, OfFlatWaterIsAMirror) {
  for (const double elevation_deg : {2.0, 20.0, 70.0, 90.0}) {
    const vec3 view = at(elevation_deg);
    const auto mirror = water_mirror(view, up(), 0);
    EXPECT_NEAR(mirror.share, water_fresnel(view.z), 1e-5L);
    EXPECT_NEAR(glm::length(mirror.direction - vec3(-view.x, -view.y, view.z)), 0, 1e-5L);
    EXPECT_LT(mirror.spread, 2e-3L);
  }
}

// The share that all facets reflect, by the area that the camera sees of each.
double share_over_slopes(const vec3& view, float mss) {
  long double reflected = 0, seen = 0;
  const float reach = 4 * std::sqrt(mss), step = reach / 150;
  for (float x = -reach; x <= reach; x += step)
    for (float y = -reach; y <= reach; y += step) {
      const vec3 facet(-x, -y, 1);
      const float area = std::max(0.0F, glm::dot(view, facet)) * slope_density(x * x + y * y, mss);
      seen += area;
      reflected += area * water_fresnel(glm::dot(view, glm::normalize(facet)));
    }
  return double(reflected / seen);
}

TEST(WaterMirror, ReflectsWhatTheFacetsDoOnAverage) {
  for (const float mss : {0.005F, 0.03F, 0.06F})
    for (const double elevation_deg : {1.0, 5.0, 15.0, 40.0, 80.0}) {
      const vec3 view = at(elevation_deg);
      EXPECT_NEAR(water_mirror(view, up(), mss).share / share_over_slopes(view, mss), 1, mss > 0.04F ? 0.12L : 0.06L)
          << elevation_deg << ", " << mss;
    }
}

TEST(WaterMirror, OfARoughSeaLooksHigherThanAMirror) {
  const auto mirror = water_mirror(at(3), up(), 0.03F);
  EXPECT_GT(mirror.direction.z, 2 * std::sin(radians(3)));
  EXPECT_NEAR(glm::length(mirror.direction), 1, 1e-4L);
}

mat4 four_trains() {
  mat4 trains(0);
  trains[0] = vec4(0.8F, 0.6F, 0, -1), trains[1] = vec4(0.6F, -0.8F, 1, 0);
  trains[2] = vec4(0.2F, 0.9F, 2.2F, 2.3F), trains[3] = vec4(0, 0.2F, 0.4F, 0.7F);
  return trains;
}

// Nothing of the slope is lost: what a footprint averages away is counted as unseen.
TEST(WaterWaves, KeepTheirMeanSquareSlopeAtAnyFootprint) {
  constexpr float slope = 0.1F;
  const double whole = 2 * slope * slope;
  Samples samples;
  for (const float width_m : {0.0F, 0.5F, 4.0F}) {
    double sum = 0, unseen = 0;
    constexpr int count = 60000;
    for (int i = 0; i < count; ++i) {
      const vec2 place(samples.between(-5000, 5000), samples.between(-5000, 5000));
      const Waves waves = add_waves(Waves(vec2(0), 0, vec2(0)), four_trains(), slope,
                                    Footprint(place, vec2(0.6F, 0.8F), 3 * width_m, width_m));
      sum += glm::dot(waves.slope, waves.slope), unseen = waves.unseen_mss;
    }
    EXPECT_NEAR((sum / count + unseen) / whole, 1, 0.02L) << width_m;
    EXPECT_LE(unseen, width_m == 0 ? 1e-6L : 1);
    EXPECT_GE(unseen, width_m == 4 ? 0.7L * whole : 0);
  }
}

TEST(WaterWaves, AcrossThePixelsLongSideAreLost) {
  mat4 east(0);
  east[0] = vec4(1), east[2] = vec4(1);
  const auto unseen = [&](const vec2& along) {
    return add_waves(Waves(vec2(0), 0, vec2(0)), east, 0.1F, Footprint(vec2(0), along, 20, 0.1F)).unseen_mss;
  };
  EXPECT_NEAR(unseen(vec2(1, 0)), 0.02L, 1e-6L);
  EXPECT_NEAR(unseen(vec2(0, 1)), 0, 1e-4L);
}

TEST(WaterWaves, HaveACosineGoodToAThousandth) {
  for (double turns = -3; turns < 3; turns += 0.01L)
    EXPECT_NEAR(glsl::quick_cosine(vec4(turns)).x, std::cos(2 * double(half_turn) * turns), 1.2e-3L) << turns;
}

}  // namespace
}  // namespace cloudscape
