// Places in a picture and view space: each the other's inverse, and nothing is seen outside the picture.
#include <gtest/gtest.h>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::vec2, glsl::vec3;

constexpr float half_height = 0.6F, aspect = 1.5F;

TEST(Reprojection, PlacesComeBackFromAnyDistance) {
  Samples samples;
  for (int i = 0; i < 1000; ++i) {
    const vec2 place(samples.between(0.001, 0.999), samples.between(0.001, 0.999));
    const auto distance = static_cast<float>(samples.between(0.1, 1e5));
    const vec3 seen = glsl::place_of_view(distance * glsl::view_ray(place, half_height, aspect), half_height, aspect);
    EXPECT_NEAR(seen.x, place.x, 1e-5);
    EXPECT_NEAR(seen.y, place.y, 1e-5);
    EXPECT_EQ(seen.z, 1);
  }
}

TEST(Reprojection, UpIsTheTopOfThePictureAndRightItsRight) {
  EXPECT_NEAR(glsl::place_of_view(vec3(0, half_height, 1), half_height, aspect).y, 0, 1e-6);
  EXPECT_NEAR(glsl::place_of_view(vec3(half_height * aspect, 0, 1), half_height, aspect).x, 1, 1e-6);
}

TEST(Reprojection, NothingIsSeenBesideThePictureOrBehindTheCamera) {
  EXPECT_EQ(glsl::place_of_view(vec3(0, 0, 1), half_height, aspect).z, 1);
  EXPECT_EQ(glsl::place_of_view(vec3(0, 0, -1), half_height, aspect).z, 0);
  EXPECT_EQ(glsl::place_of_view(vec3(0, 1.01F * half_height, 1), half_height, aspect).z, 0);
  EXPECT_EQ(glsl::place_of_view(vec3(-1.01F * half_height * aspect, 0, 1), half_height, aspect).z, 0);
}

}  // namespace
}  // namespace cloudscape
