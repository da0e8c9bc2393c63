// The traced air, in long runs: against the Monte Carlo tracer, and the sky tables against it. Prints a row of a table
// for each.
#include <ctime>

#include "gpu/trace/planet.h"
#include "settings/cloudscape_json.h"

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

// A deck of cloud that the ground cannot be seen through, from above and far away. The tables know no light but the
// ground's from below: they are right where that is as bright as the deck.
TEST_F(TruthOfTheAir, ACloudDeckThroughThirtyKilometres) {
  for (const double sun_deg : {60.0, 10.0}) {
    Cloudscape sky = clear_world(sun_deg, 0.1);
    sky.volume.kind = VolumeKind::slab;
    sky.volume.origin_m = {0, 0, 1000}, sky.volume.size_m = {1000, 1000, 1000};
    sky.medium.extinction_per_m = 0.03;
    sky.medium.phase = {PhaseKind::henyey_greenstein, 0.85};
    const Look look{5000, 90, degrees(-std::asin(3.0 / 30))};
    const Colours air = seen(sky, look, 64, 64);
    const auto against = [&](double albedo) {
      sky.ground.albedo = glm::dvec3(albedo);
      const Colours tables = colours_of(traced(traced_beam(sky, pose_of(look), 64, 64)));
      const glm::dvec3 difference = tables.mean / air.mean - 1.0,
                       error = glm::sqrt(air.error * air.error / (air.mean * air.mean) +
                                         tables.error * tables.error / (tables.mean * tables.mean));
      std::printf("| deck, %s, ground %.2f | %s | %s |\n", name_of(sun_deg, look).c_str(), albedo,
                  percents(difference).c_str(), percents(error).c_str());
      std::fflush(stdout);
      return difference;
    };
    EXPECT_LT(against(0.1).z, -0.1);
    const glm::dvec3 bright = against(0.72);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(bright[i], 0, 0.18) << sun_deg;
  }
}

// A picture of a preset, by the kind of thing that each pixel shows.
struct Parts {
  double sky[3]{}, cloud[3]{}, ground[3]{}, seconds = 0, relative_error = 0;
};

Parts parts_of(const FrameRequest& request) {
  const auto start = std::clock();
  const Frame frame = TraceTest::traced(request);
  Parts parts{.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    const float* rgba = frame.radiance_rgba.data() + 4 * i;
    double* part = rgba[3] > 0.9F            ? parts.cloud
                   : rgba[3] > 0.01F         ? nullptr
                   : frame.depth_m[i] < 1e6F ? parts.ground
                                             : parts.sky;
    for (std::size_t c = 0; c < 3; ++c) {
      squares += std::pow(frame.standard_error_rgb[3 * i + c], 2), sum += rgba[c];
      if (part) part[c] += rgba[c];
    }
  }
  parts.relative_error = std::sqrt(squares * 3 * static_cast<double>(frame.depth_m.size())) / sum;
  return parts;
}

TEST_F(TruthOfTheAir, CostOfAPreset) {
  const char* wanted = std::getenv("TRACED_PRESET");
  const auto sky = settings::CloudscapeLibrary{{}}.get(wanted ? wanted : "fair-weather-cumulus");
  FrameRequest request = traced_picture(*sky, sky->view.pose, {256, 144}, 32);
  request.lens = sky->view.lens;
  FrameRequest warm_up = request;
  warm_up.quality.samples = 1;
  parts_of(warm_up), parts_of(through_air(warm_up));
  const Parts tables = parts_of(request), air = parts_of(through_air(request));
  const auto ratio = [](const double(&a)[3], const double(&b)[3]) {
    return percents(glm::dvec3(a[0] / b[0], a[1] / b[1], a[2] / b[2]) - 1.0);
  };
  std::printf("time %.1f s by tables, %.1f s traced; error of a pixel %.3f, %.3f of the mean\n", tables.seconds,
              air.seconds, tables.relative_error, air.relative_error);
  std::printf("tables over traced: sky %s; cloud %s; ground %s\n", ratio(tables.sky, air.sky).c_str(),
              ratio(tables.cloud, air.cloud).c_str(), ratio(tables.ground, air.ground).c_str());
  std::fflush(stdout);
  EXPECT_GT(air.sky[2], 0.5 * tables.sky[2]);
}

TEST_F(TruthOfTheAir, AWhitePlanetSendsOutWhatItTakes) {
  for (const double cloud_depth : {0.0, 1.0}) {
    const Colours share = sent_out(cloud_depth, 64, 128);
    std::printf("| white planet, cloud of optical depth %.0f | 1 | %.4f, %.4f, %.4f | %s |\n", cloud_depth,
                share.mean.x, share.mean.y, share.mean.z, percents(share.error).c_str());
    std::fflush(stdout);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(share.mean[i], 1, 4 * share.error[i] + 0.001) << "colour " << i;
  }
}

}  // namespace
}  // namespace cloudscape::render
