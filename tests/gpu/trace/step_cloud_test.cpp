// The step cloud, in a short run.
#include "step_cloud.h"

namespace cloudscape::render {
namespace {

using TracedStepCloud = OwnStackTest;

TEST_F(TracedStepCloud, ReflectsAsOtherCodesSay) {
  StepCloud cloud;
  for (const StepCloudTruth& truth : step_cloud_truths) {
    const Measured reflected = cloud.flux(truth.zenith_deg, truth.albedo, true, 8);
    EXPECT_NEAR(reflected.mean, truth.reflected, 4 * reflected.error + 0.005 * truth.reflected) << truth.zenith_deg;
    EXPECT_LT(reflected.error, 0.01);
  }
}

}  // namespace
}  // namespace cloudscape::render
