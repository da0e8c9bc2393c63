// Long runs of the path tracer against independent truth, to 1 %. Prints a row of a table for each.
#include "gpu/trace/slab_cases.h"

namespace cloudscape::render {
namespace {

using Truth = TraceTest;

void compare(const std::string& what, double expected, const Measured& got) {
  if (expected == 0) return;
  std::printf("| %s | %.5f | %.5f | %.2f %% | %+.2f %% |\n", what.c_str(), expected, got.mean,
              100 * got.error / expected, 100 * (got.over(expected) - 1));
  std::fflush(stdout);
  EXPECT_NEAR(got.over(expected), 1, 0.01) << what;
  EXPECT_NEAR(got.mean, expected, 4 * got.error + 2e-4 * expected) << what;
}

std::string name_of(const SlabTruth& truth, const char* what) {
  char text[120];
  std::snprintf(text, sizeof text, "slab, g %.2f, optical thickness %.0f, albedo %.1f: %s", truth.asymmetry_g,
                truth.optical_thickness, truth.albedo, what);
  return text;
}

TEST_F(Truth, SlabFluxes) {
  for (const SlabTruth& truth : slab_truths) {
    // As many samples as the rarer of the two events needs.
    const int samples = truth.reflected > 0 && truth.reflected < 0.1 ? 1024 : 256;
    compare(name_of(truth, "reflected"), truth.reflected, slab_flux(truth, true, 64, samples));
    compare(name_of(truth, "transmitted"), truth.transmitted, slab_flux(truth, false, 64, samples));
  }
}

TEST_F(Truth, SlabReflectanceFactors) {
  for (const SlabTruth& truth : slab_truths) {
    if (truth.factor == 0) continue;
    compare(name_of(truth, "factor at nadir"), truth.factor,
            slab_factor(truth, 128, truth.optical_thickness < 2 ? 384 : 96));
  }
}

}  // namespace
}  // namespace cloudscape::render
