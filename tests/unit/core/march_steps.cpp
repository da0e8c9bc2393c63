// What a ray costs: the steps of the view ray, and from each of them those towards the sun.
#include "core/march_steps.h"

#include <gtest/gtest.h>

namespace cloudscape {
namespace {

TEST(MarchSteps, AreTheQualitysWhereTheMarchNamesNone) {
  EXPECT_EQ(march_steps({}, render_quality(Quality::standard)).view, 256);
  EXPECT_EQ(march_steps({}, render_quality(Quality::standard)).light, 6);
  EXPECT_EQ(most_steps_of_ray({}, render_quality(Quality::standard)), 256 * 7);
  EXPECT_EQ(most_steps_of_ray({}, render_quality(Quality::finest)), 1024 * 25);
}

TEST(MarchSteps, AreTheMarchsWhereItNamesThem) {
  March march;
  march.max_steps = 100;
  march.light_steps = 9;
  EXPECT_EQ(most_steps_of_ray(march, {}), 1000);
  march.lighting = false;
  EXPECT_EQ(most_steps_of_ray(march, {}), 100);
}

TEST(MarchSteps, NeverGoRoundMoreOftenThanASoftwareRasterizerDoes) {
  March march;
  march.max_steps = 16384;
  for (const int light_steps : {1, 6, 128}) {
    march.light_steps = light_steps;
    const MarchSteps steps = march_steps(march, {});
    EXPECT_LE(steps.view * (light_steps + 2), 65535);
    EXPECT_EQ(steps.view, std::min(16384, 65000 / (light_steps + 2)));
  }
}

}  // namespace
}  // namespace cloudscape
