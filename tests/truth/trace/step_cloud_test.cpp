// The step cloud, in long runs.
#include "gpu/trace/step_cloud.h"

namespace cloudscape::render {
namespace {

using TruthOfTheStepCloud = OwnStackTest;

void compare(const StepCloudTruth& truth, const char* what, double expected, const Measured& got) {
  std::printf("| step cloud, sun at %.0f degrees, albedo %.2f: %s | %.5f | %.5f | %.2f %% | %+.2f %% |\n",
              truth.zenith_deg, truth.albedo, what, expected, got.mean, 100 * got.error / expected,
              100 * (got.over(expected) - 1));
  std::fflush(stdout);
  EXPECT_NEAR(got.over(expected), 1, 0.01) << what;
}

TEST_F(TruthOfTheStepCloud, MeansOverThePeriod) {
  StepCloud cloud;
  for (const StepCloudTruth& truth : step_cloud_truths) {
    compare(truth, "reflected", truth.reflected, cloud.flux(truth.zenith_deg, truth.albedo, true, 96));
    if (truth.transmitted > 0)
      compare(truth, "transmitted", truth.transmitted, cloud.flux(truth.zenith_deg, truth.albedo, false, 96));
    if (truth.factor > 0) compare(truth, "factor at nadir", truth.factor, cloud.factor(truth.zenith_deg, 384));
  }
}

}  // namespace
}  // namespace cloudscape::render
