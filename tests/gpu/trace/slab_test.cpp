// Multiple scattering in plane-parallel clouds, against published values.
#include "slab_cases.h"

namespace cloudscape::render {
namespace {

using TracedSlab = TraceTest;

TEST_F(TracedSlab, ReflectsAndTransmitsAsPublished) {
  for (const SlabTruth& truth : slab_truths) {
    const auto expect = [&](const char* what, double expected, const Measured& got) {
      if (expected == 0) return;
      EXPECT_NEAR(got.mean, expected, 4 * got.error)
          << what << ": g " << truth.asymmetry_g << ", tau " << truth.optical_thickness;
    };
    expect("reflected", truth.reflected, slab_flux(truth, true, 64, 8));
    expect("transmitted", truth.transmitted, slab_flux(truth, false, 64, 8));
    expect("factor", truth.factor, slab_factor(truth, 64, 8));
  }
}

}  // namespace
}  // namespace cloudscape::render
