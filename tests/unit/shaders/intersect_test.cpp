// Where rays meet shapes, in 32 bits, against long double.
#include "unit/shaders/glsl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::vec2, glsl::vec3;

constexpr int radius_m = 6360000;  // of the planet, Hillaire 2020

struct Interval {
  long double near, far;
};
using Hit = std::optional<Interval>;

// Roots of a t^2 + 2 b t + c.
Hit roots(long double a, long double b, long double c) {
  const long double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const long double root = std::sqrt(discriminant);
  return Interval{(-b - root) / a, (-b + root) / a};
}

using lvec3 = glm::tvec3<long double>;

Hit exact_sphere(vec3 origin, vec3 direction, vec3 center, long double radius) {
  const lvec3 o = lvec3(origin) - lvec3(center), d(direction);
  return roots(glm::dot(d, d), glm::dot(o, d), glm::dot(o, o) - radius * radius);
}
Hit exact_altitude(vec3 origin, vec3 direction, long double altitude) {
  return exact_sphere(origin, direction, vec3(0, 0, -radius_m), radius_m + altitude);
}
long double exact_altitude_at(vec3 origin, vec3 direction, long double distance) {
  const lvec3 p = lvec3(origin) + distance * lvec3(direction) + lvec3(0, 0, radius_m);
  return glm::length(p) - radius_m;
}
Hit hit_of(vec2 interval) {
  if (interval.x > interval.y) return std::nullopt;
  return Interval{interval.x, interval.y};
}

TEST(Sphere, MeetsTheExactIntervalFromAllSides) {
  Samples samples;
  int inside = 0, missed = 0;
  for (int i = 0; i < 20000; ++i) {
    const vec3 center(300, -200, 1500), origin = center + samples.in_box(vec3(-3000), vec3(3000));
    const float radius = samples.between(100, 2500);
    const vec3 direction = samples.direction();
    const Hit exact = exact_sphere(origin, direction, center, radius);
    const Hit found = hit_of(glsl::intersect_sphere(origin, direction, center, radius));
    const double chord = exact ? exact->far - exact->near : 0;
    if (chord < 20) {  // grazing or a miss: only what there is of a chord may differ
      ASSERT_LT(found ? static_cast<double>(found->far - found->near) : 0, 21);
      ++missed;
      continue;
    }
    ASSERT_TRUE(found);
    ASSERT_NEAR(found->near, exact->near, 0.05);  // kilometres in 32 bits: 0.5 mm, times the slope of the sphere
    ASSERT_NEAR(found->far, exact->far, 0.05);
    inside += exact->near < 0 && exact->far > 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(missed, 500);
}

TEST(Sphere, GrazesWithinAMillimetreOfItsRadius) {
  const vec3 center(0, 5000, 1000), forward(0, 1, 0);
  EXPECT_TRUE(hit_of(glsl::intersect_sphere(vec3(999.999, 0, 1000), forward, center, 1000)));
  EXPECT_FALSE(hit_of(glsl::intersect_sphere(vec3(1000.001, 0, 1000), forward, center, 1000)));
}

TEST(Sphere, LiesBehindWhoeverLooksAway) {
  const Hit behind = hit_of(glsl::intersect_sphere(vec3(0), vec3(0, -1, 0), vec3(0, 5000, 0), 1000));
  ASSERT_TRUE(behind);
  EXPECT_EQ(behind->near, -6000);
  EXPECT_EQ(behind->far, -4000);
}

Hit exact_box(vec3 origin, vec3 direction, vec3 low, vec3 high) {
  Interval interval{-1e30L, 1e30L};
  for (int axis = 0; axis < 3; ++axis) {
    const long double o = origin[axis], d = direction[axis];
    if (d == 0 && (o < low[axis] || o > high[axis])) return std::nullopt;
    if (d == 0) continue;
    interval.near = std::max(interval.near, std::min((low[axis] - o) / d, (high[axis] - o) / d));
    interval.far = std::min(interval.far, std::max((low[axis] - o) / d, (high[axis] - o) / d));
  }
  return interval.near > interval.far ? std::nullopt : Hit(interval);
}

TEST(Box, MeetsTheExactIntervalFromAllSides) {
  Samples samples;
  const vec3 low(-1000, -500, 900), high(1500, 700, 2600);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const vec3 origin = samples.in_box(vec3(-4000), vec3(4000)), direction = samples.direction();
    const Hit exact = exact_box(origin, direction, low, high);
    const Hit found = hit_of(glsl::intersect_box(origin, direction, low, high));
    if (exact && exact->far - exact->near < 1) continue;
    ASSERT_EQ(found.has_value(), exact.has_value());
    if (!exact) continue;
    ASSERT_NEAR(found->near, exact->near, 1e-3 + 4e-7 * std::abs(exact->near));
    ASSERT_NEAR(found->far, exact->far, 1e-3 + 4e-7 * std::abs(exact->far));
    ++hits;
  }
  EXPECT_GT(hits, 1000);
}

TEST(Box, IsMetByRaysAlongItsEdges) {
  const vec3 low(-1, -2, -3), high(1, 2, 3);
  const Hit inside = hit_of(glsl::intersect_box(vec3(0.5, 0.5, 0.5), vec3(0, 0, 1), low, high));
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->near, -3.5);
  EXPECT_EQ(inside->far, 2.5);
  EXPECT_FALSE(hit_of(glsl::intersect_box(vec3(1.5, 0, -9), vec3(0, 0, 1), low, high)));
  EXPECT_FALSE(hit_of(glsl::intersect_box(vec3(0, -2.5, 0), vec3(1, 0, 0), low, high)));
}

TEST(Slab, IsEndlessForAHorizontalRayInside) {
  const Hit inside = hit_of(glsl::intersect_slab(1500, 0, 1000, 2000));
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->near, -glsl::no_hit_m);
  EXPECT_EQ(inside->far, glsl::no_hit_m);
  EXPECT_FALSE(hit_of(glsl::intersect_slab(2500, 0, 1000, 2000)));
  const Hit below = hit_of(glsl::intersect_slab(500, 0.5, 1000, 2000));
  ASSERT_TRUE(below);
  EXPECT_EQ(below->near, 1000);
  EXPECT_EQ(below->far, 3000);
}

// All altitudes of a camera and of a surface, all elevations: the points found lie on the surface, and the distances
// are right wherever the ray does not graze.
class Altitude : public testing::Test {
 protected:
  template <class Check>
  static void for_each_ray(Check check) {
    for (const float camera : {0.0F, 2.0F, 150.0F, 999.0F, 1000.5F, 1800.0F, 4000.0F, 12000.0F, 30000.0F})
      for (const float surface : {-10.0F, 0.0F, 1000.0F, 1600.0F, 2600.0F, 12000.0F, 100000.0F})
        for (int i = -360; i <= 360; ++i) {
          const long double elevation = i * std::abs(i) / 129600.0L * 1.5707963267948966L;  // fine about the horizon
          const vec3 direction(0.6L * std::cos(elevation), 0.8L * std::cos(elevation), std::sin(elevation));
          check(vec3(0, 0, camera), direction, surface);
        }
  }
};

TEST_F(Altitude, IsRightAtThePointsFound) {
  for_each_ray([](vec3 origin, vec3 direction, float surface) {
    const Hit found = hit_of(glsl::intersect_altitude(origin, direction, surface));
    if (!found) return;
    for (const long double distance : {found->near, found->far}) {
      if (std::abs(distance) > 1.2e6L) continue;  // the far side of the planet
      // Near: centimetres. Far: 2^-23 of the way to the planet's middle for each of a few roundings, along the ray.
      ASSERT_NEAR(exact_altitude_at(origin, direction, distance), surface, 0.02 + 3e-7 * std::abs(distance))
          << origin.z << ' ' << surface << ' ' << direction.z << ' ' << distance;
    }
  });
}

TEST_F(Altitude, HasTheExactDistanceUnlessItGrazes) {
  int checked = 0;
  for_each_ray([&](vec3 origin, vec3 direction, float surface) {
    const Hit exact = exact_altitude(origin, direction, surface);
    const Hit found = hit_of(glsl::intersect_altitude(origin, direction, surface));
    if (!exact || exact->far - exact->near < 20000) return;
    ASSERT_TRUE(found);
    // Half the chord divides the rounding of altitudes: R / half chord is how flat the ray meets the surface.
    const double flatness = 6.36e6 / static_cast<double>(exact->far - exact->near);
    for (const auto& [is, should] : {std::pair{found->near, exact->near}, {found->far, exact->far}})
      ASSERT_NEAR(is, should, (0.02 + 4e-7 * std::abs(should)) * (1 + 2 * flatness))
          << origin.z << ' ' << surface << ' ' << direction.z;
    ++checked;
  });
  EXPECT_GT(checked, 10000);
}

TEST_F(Altitude, MissesWhereTheRayPassesAbove) {
  const auto distance = [](float camera, float dz, float surface) {
    return hit_of(glsl::intersect_altitude(vec3(0, 0, camera), vec3(std::sqrt(1 - dz * dz), 0, dz), surface));
  };
  // The horizon of 1000 m lies 1.016 degrees down: cos = R / (R + h).
  EXPECT_FALSE(distance(1000, -std::sin(0.0170F), 0));
  EXPECT_TRUE(distance(1000, -std::sin(0.0185F), 0));
}

TEST(AltitudeOf, IsExactToAMetreWithin200Km) {
  for (const float z : {-50.0F, 0.0F, 500.0F, 12000.0F, 60000.0F})
    for (int km = 0; km <= 200; km += 5) {
      const vec3 p(600 * km, -800 * km, z);
      // The parabola leaves out distance^4 / (8 R^3): 3 mm at 50 km, 0.8 m at 200 km.
      EXPECT_NEAR(glsl::altitude_of(p), exact_altitude_at(p, vec3(0), 0), km <= 50 ? 0.02 : 1);
    }
}

}  // namespace
}  // namespace cloudscape
