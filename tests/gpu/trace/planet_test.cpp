// No light is lost or made in the air, in a short run.
#include "planet.h"

namespace cloudscape::render {
namespace {

using TracedPlanet = TraceTest;

TEST_F(TracedPlanet, SendsOutWhatItTakes) {
  for (const double cloud_depth : {0.0, 1.0}) {
    const Colours share = sent_out(cloud_depth, 32, 16);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(share.mean[i], 1, 4 * share.error[i] + 0.003) << "colour " << i;
    EXPECT_LT(share.error.x, 0.01);
  }
}

}  // namespace
}  // namespace cloudscape::render
