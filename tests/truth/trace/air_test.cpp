// The traced air, in long runs: against the Monte Carlo tracer, and the sky tables against it. Prints a row of a table
// for each.
#include "gpu/trace/planet.h"

namespace cloudscape::render {
namespace {

using TruthOfTheAir = TraceTest;

std::string percents(const glm::dvec3& shares) {
  char text[60];
  std::snprintf(text, sizeof text, "%+.1f, %+.1f, %+.1f %%", 100 * shares.x, 100 * shares.y, 100 * shares.z);
  return text;
}

TEST_F(TruthOfTheAir, SkiesAndGround) {
  for (const double sun_deg : {60.0, 10.0, 2.0})
    for (const Look& look : looks) {
      const Cloudscape sky = clear_world(sun_deg, 0.3);
      const Colours ours = seen(sky, look, 64, 64);
      const TracedRadiance truth = by_photons(sun_deg, 0.3, look, 60000);
      const glm::dvec3 error = truth.error / truth.mean, own_error = ours.error / ours.mean,
                       difference = ours.mean / truth.mean - 1.0, tables = by_tables(sky, look) / ours.mean - 1.0;
      std::printf("| %s | %s | %s | %s | %s |\n", name_of(sun_deg, look).c_str(), percents(difference).c_str(),
                  percents(error).c_str(), percents(own_error).c_str(), percents(tables).c_str());
      std::fflush(stdout);
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(difference[i], 0, 0.005 + 3.5 * std::hypot(error[i], own_error[i])) << name_of(sun_deg, look);
        EXPECT_NEAR(tables[i], 0, 0.08 + 3 * own_error[i]) << name_of(sun_deg, look);
      }
    }
}

// A deck of cloud that the ground cannot be seen through, from above and far away.
TEST_F(TruthOfTheAir, ACloudDeckThroughThirtyKilometres) {
  for (const double sun_deg : {60.0, 10.0}) {
    Cloudscape sky = clear_world(sun_deg, 0.1);
    sky.volume.kind = VolumeKind::slab;
    sky.volume.origin_m = {0, 0, 1000}, sky.volume.size_m = {1000, 1000, 1000};
    sky.medium.extinction_per_m = 0.03;
    sky.medium.phase = {PhaseKind::henyey_greenstein, 0.85};
    for (const double azimuth_deg : {0.0, 90.0, 180.0}) {
      const Look look{5000, azimuth_deg, degrees(-std::asin(3.0 / 30))};
      const Colours air = seen(sky, look, 64, 32);
      const Colours tables = colours_of(traced(traced_beam(sky, pose_of(look), 64, 32)));
      const glm::dvec3 difference = tables.mean / air.mean - 1.0, error = air.error / air.mean;
      std::printf("| deck, %s | %s | %s |\n", name_of(sun_deg, look).c_str(), percents(difference).c_str(),
                  percents(error + tables.error / tables.mean).c_str());
      std::fflush(stdout);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(difference[i], 0, 0.1 + 4 * error[i]) << name_of(sun_deg, look);
    }
  }
}

TEST_F(TruthOfTheAir, AWhitePlanetSendsOutWhatItTakes) {
  for (const double cloud_depth : {0.0, 1.0}) {
    const Colours share = sent_out(cloud_depth, 64, 128);
    std::printf("| white planet, cloud of optical depth %.0f | 1 | %.4f, %.4f, %.4f | %s |\n", cloud_depth,
                share.mean.x, share.mean.y, share.mean.z, percents(share.error).c_str());
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(share.mean[i], 1, 4 * share.error[i] + 0.001) << "colour " << i;
  }
}

}  // namespace
}  // namespace cloudscape::render
