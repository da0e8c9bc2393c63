// Multiple scattering in plane-parallel clouds, against published values.
#include "slab_cases.h"

namespace cloudscape::render {
namespace {

using TracedSlab = TraceTest;

TEST_F(TracedSlab, ReflectsAndTransmitsAsPublished) {
  for (const SlabTruth& truth : slab_truths) {
    const auto expect = [&](const char* what, double expected, const Measured& got) {
      if (expected == 0) return;
      EXPECT_NEAR(got.mean, expected, 4 * got.error) << what << ": g " << truth.asymmetry_g << ", tau " << truth.optical_thickness;
      std::printf("g %g tau %g albedo %g %s: %.5f +- %.5f, expected %.5f (%+.2f %%)\n", truth.asymmetry_g, truth.optical_thickness, truth.albedo, what, got.mean, got.error, expected, 100*(got.mean/expected-1));
    };
    expect("reflected", truth.reflected, slab_flux(truth, true, 16, 256));
    expect("transmitted", truth.transmitted, slab_flux(truth, false, 16, 256));
    expect("factor", truth.factor, slab_factor(truth, 16, 256));
  }
}

}  // namespace
}  // namespace cloudscape::render
