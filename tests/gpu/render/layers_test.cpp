// Several layers in one volume: each where it is to be and as dense, for all that look at it.
#include "layered_clouds.h"
#include "render/density_export.h"

namespace cloudscape::render {
namespace {

using SeveralLayers = RenderTest;

double mean_opacity(const Frame& frame) {
  double sum = 0;
  const std::size_t pixels = frame.depth_m.size();
  for (std::size_t i = 0; i < pixels; ++i) sum += opacity(frame, static_cast<int>(i));
  return sum / static_cast<double>(pixels);
}

TEST_F(SeveralLayers, AreSeenFromBelowBetweenAndAbove) {
  const Cloudscape sky = layered_clouds();
  const auto seen = [&](double altitude_m, double elevation_deg) {
    return mean_opacity(render(picture(sky, {{0, 0, altitude_m}, 20, elevation_deg, 0}, {24, 16})));
  };
  EXPECT_GT(seen(100, 60), 0.1) << "from below";
  EXPECT_GT(seen(2250, 50), 0.05) << "the deck from between";
  EXPECT_GT(seen(2250, -50), 0.05) << "the heaps from between";
  EXPECT_GT(seen(5000, -60), 0.1) << "from above";
  EXPECT_EQ(seen(2910, 40), 0) << "nothing above the deck; a texel is 31 m";
  EXPECT_EQ(seen(965, -40), 0) << "nor below the heaps";
  Cloudscape deck = sky;
  deck.shape.density = 0;
  EXPECT_EQ(mean_opacity(render(picture(deck, {{0, 0, 2465}, 20, -50, 0}, {24, 16}))), 0) << "below the deck";
}

// A layer that fills its altitudes, straight up and at a slant: optical depth by extinction, density and way.
TEST_F(SeveralLayers, HaveTheOpticalDepthOfTheirDensity) {
  Cloudscape sky = small_clouds();
  sky.volume.resolution = 64;
  sky.shape.threshold = -1, sky.detail.strength = 0;
  sky.shape.bottom_m = 1500, sky.shape.top_m = 2000;
  sky.medium.extinction_per_m = 0.002;
  sky.ground.kind = GroundKind::none, sky.sky.kind = SkyKind::none;
  for (const double density : {1.0, 0.5, 0.1})
    for (const double elevation_deg : {90.0, 40.0}) {
      sky.shape.density = density;
      const double seen = opacity(render(one_beam(sky, {{100, 200, 500}, 10, elevation_deg, 0})));
      const double expected = 0.002 * density * 500 / std::sin(radians(elevation_deg));
      EXPECT_NEAR(-std::log(1 - seen), expected, 0.03 * expected) << density << " at " << elevation_deg;
    }
}

// Of a further layer, too: through each ray the same share.
TEST_F(SeveralLayers, OfLessDensityAreAsMuchThinner) {
  Cloudscape sky = layered_clouds();
  sky.ground.kind = GroundKind::none, sky.sky.kind = SkyKind::none;
  sky.shape.density = 0;
  sky.medium.extinction_per_m = 0.004;
  const FrameRequest thin = picture(sky, {{0, 0, 500}, 20, 60, 0}, {24, 16});
  sky.layers[0].density = 1;
  FrameRequest thick = thin;
  thick.cloudscape = std::make_shared<const Cloudscape>(sky);
  const Frame a = render(thin), b = render(thick);
  int through = 0;
  for (int i = 0; i < 24 * 16; ++i) {
    if (opacity(b, i) < 0.02 || opacity(b, i) > 0.98) continue;
    ++through;
    EXPECT_NEAR(std::log(1 - opacity(a, i)) / std::log(1 - opacity(b, i)), 0.25, 0.01) << i;
  }
  EXPECT_GT(through, 50);
}

// What other programs are given is what the march goes through.
TEST_F(SeveralLayers, AreExportedWithTheirDensity) {
  const Cloudscape sky = layered_clouds();
  const auto baked = stack().bakes.get(bake::bake_recipe(sky));
  DensityExport density(stack().shaders, sky, *baked, 64);  // voxels of 125 m: two layers' altitudes apart
  ASSERT_EQ(density.size(), glm::ivec3(64, 64, 16));
  std::vector<float> greatest;
  for (int z = 0; z < 16; z += DensityExport::slab) {
    const std::vector<float> slices = density.slices(z);
    for (std::size_t i = 0; i < slices.size(); i += 64 * 64)
      greatest.push_back(*std::max_element(slices.begin() + static_cast<std::ptrdiff_t>(i),
                                           slices.begin() + static_cast<std::ptrdiff_t>(i + 64 * 64)));
  }
  ASSERT_EQ(greatest.size(), 16U);
  EXPECT_GT(*std::max_element(greatest.begin(), greatest.begin() + 8), 0.45) << "the heaps, more than the deck ever is";
  for (const int clear : {9, 10, 15}) EXPECT_EQ(greatest[static_cast<std::size_t>(clear)], 0) << clear;
  const float of_deck = *std::max_element(greatest.begin() + 11, greatest.end());
  EXPECT_GT(of_deck, 0.15);
  EXPECT_LE(of_deck, 0.2501);
}

// The threshold that is common to all layers swings over the land.
TEST_F(SeveralLayers, ChangeTheirCoverageOverTheLand) {
  Cloudscape sky = layered_clouds();
  const CameraPose pose{{0, 0, 100}, 20, 30, 0};
  const Frame even = render(picture(sky, pose, {24, 16}));
  sky.shape.coverage_variation = {0.8, 20000};
  const Frame varied = render(picture(sky, pose, {24, 16}));
  double difference = 0;
  for (int i = 0; i < 24 * 16; ++i) difference = std::max(difference, std::abs(opacity(even, i) - opacity(varied, i)));
  EXPECT_GT(difference, 0.3);
}

// The same clouds, but for the steps of the numbers that they are kept in.
TEST_F(SeveralLayers, OfWhichThereIsOneInAllOfTheVolumeAreThatOne) {
  Cloudscape sky = small_clouds();
  sky.volume.resolution = 64;
  sky.volume.format = VolumeFormat::r16f;
  sky.shape.coverage = 0.4;
  for (const std::optional<double> threshold : {std::optional<double>{}, {0.45}}) {
    sky.shape.threshold = threshold;
    Cloudscape layered = sky;
    layered.shape.top_m = 3000;
    for (const double elevation_deg : {20.0, 60.0}) {
      const CameraPose pose{{0, 0, 100}, 20, elevation_deg, 0};
      const Frame a = render(picture(sky, pose, {24, 16})), b = render(picture(layered, pose, {24, 16}));
      double difference = 0, light = 0;
      for (int i = 0; i < 24 * 16; ++i)
        difference += std::abs(opacity(a, i) - opacity(b, i)), light += std::abs(red(a, i) - red(b, i)) / red(a, i);
      EXPECT_LT(difference / (24 * 16), 0.01);
      EXPECT_LT(light / (24 * 16), 0.02);
      EXPECT_GT(mean_opacity(b), 0.02);
    }
  }
}

TEST_F(SeveralLayers, AreTheSameTwice) {
  const FrameRequest request = picture(layered_clouds(), {{0, 0, 100}, 20, 40, 0}, {24, 16});
  const Frame first = render(request), second = render(request);
  EXPECT_EQ(first.radiance_rgba, second.radiance_rgba);
}

}  // namespace
}  // namespace cloudscape::render
