// What comes through clouds of the light of sky, horizon and ground: against closed forms, conservation of energy and
// an independent march, and how it is baked.
#include "render/ambient_visibility.h"

#include "core/wind.h"
#include "gpu/render/cloud_grid.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

constexpr int across = AmbientVisibilities::across, layers = AmbientVisibilities::layers;
constexpr int slices = layers / AmbientVisibilities::layers_per_slice;  // one level: coverage is the same everywhere
constexpr double g = 0.5, extinction_per_m = 0.02;

Cloudscape with_medium(Cloudscape sky) {
  sky.medium.phase = {PhaseKind::henyey_greenstein, g};
  sky.medium.extinction_per_m = extinction_per_m;
  return sky;
}

double slab_transmittance(double depth) { return 1 / (1 + 0.75 * (1 - g) * depth); }

// Lit by sky and ground alone, which are of these radiances.
Cloudscape without_sun(Cloudscape sky, double above, double below) {
  sky.sun.irradiance = glm::dvec3(0), sky.sun.disc = false;
  sky.sky.kind = SkyKind::uniform, sky.sky.radiance = glm::dvec3(above);
  sky.ground.kind = above == below ? GroundKind::none : GroundKind::plain;
  sky.ground.albedo = glm::dvec3(below), sky.ground.variation = 0;
  return sky;
}

class AmbientVisibilityTest : public CloudGridTest {
 protected:
  struct Baked {
    CloudDensities densities{stack().shaders};
    AmbientVisibilities visibilities{stack().shaders, densities};
  };
  static std::shared_ptr<const gpu::Texture> bake(Baked& with, const Cloudscape& sky) {
    const FrameRequest request = one_ray(sky, {{0, 0, 100}, 0, 0, 0});
    const auto baked = baked_of(sky);
    CloudBlock cloud = cloud_block(request, *baked);
    set_mean_cosine(cloud, g);
    std::shared_ptr<const gpu::Texture> visibility;
    for (int calls = 1; calls < 1000; ++calls)
      if (with.visibilities.prepare({request, cloud, baked}, visibility)) return visibility;
    return nullptr;
  }
  struct Parts {
    double above, beside, below;
  };
  static Parts parts_at(const std::vector<float>& values, int x, int y, int layer) {
    const auto cell = 4 * static_cast<std::size_t>((layer * across + y) * across + x);
    return {values[cell], values[cell + 1], values[cell + 2]};
  }
  static std::vector<float> visibility(const Cloudscape& sky) {
    Baked with;
    return values_of(*bake(with, sky));
  }
};

TEST_F(AmbientVisibilityTest, OfAFullLayerItIsThatOfSlabs) {
  const std::vector<float> values = visibility(with_medium(full_layer(40)));
  const auto slab = [](double thickness_m, double sine) {
    return slab_transmittance(extinction_per_m * thickness_m / sine);
  };
  Parts lower{0, 0, 2};
  for (int layer = 0; layer < layers; ++layer) {
    const double under_m = 2000.0 * layer / (layers - 1), over_m = 2000 - under_m;
    const Parts seen = parts_at(values, 7, 30, layer);
    EXPECT_NEAR(seen.above, slab(over_m, 0.75), 2e-3) << "layer " << layer;
    EXPECT_NEAR(seen.beside, 0.5 * (slab(over_m, 0.05) + slab(over_m, 0.25)), 2e-3) << "layer " << layer;
    EXPECT_NEAR(seen.below, 0.5 * (slab(under_m, 0.25) + slab(under_m, 0.75)), 2e-3) << "layer " << layer;
    EXPECT_TRUE(seen.above > lower.above && seen.beside > lower.beside && seen.below < lower.below) << layer;
    lower = seen;
  }
  EXPECT_EQ(lower.above, 1);
  EXPECT_EQ(lower.beside, 1);
}

// Detail included, which the grid has as a mean only; of clouds that stand upright and of such that lean by a third of
// their height.
TEST_F(AmbientVisibilityTest, OfBrokenCloudsItIsWhatAFineMarchSees) {
  for (const double shear_per_s : {0.0, 0.002}) {
    Cloudscape sky = with_medium(broken_clouds(90, 50));
    sky.wind.shear_per_s = shear_per_s, sky.wind.towards_azimuth_deg = 30;
    const glm::dvec2 lean = lean_m(sky);
    EXPECT_EQ(glm::length(lean) > 300, shear_per_s > 0);
    const auto baked = baked_of(sky);
    const Voxels voxels = voxels_of(DensityExport(stack().shaders, sky, *baked, 192));
    const CloudBlock cloud = cloud_block(one_ray(sky, {}), *baked);
    const std::vector<float> values = visibility(sky);
    std::vector<double> above, below, marched_above, marched_below;
    for (const int layer : {0, 6, 11})
      for (int y = 0; y < across; y += 3)
        for (int x = 0; x < across; x += 3) {
          const double up = double(layer) / (layers - 1);
          const double z_m = std::lerp(double(cloud.march.z), double(cloud.march.w), up) - 1000;
          const glm::dvec2 at_m = glm::dvec2(x + 0.5, y + 0.5) / double(across) * 8000.0 + lean * z_m / 2000.0;
          const auto seen_along = [&](double sine, double turned) {
            double sum = 0;
            for (int i = 0; i < 4; ++i) {
              const double azimuth = std::numbers::pi / 2 * (i + turned), cosine = std::sqrt(1 - sine * sine);
              const glm::dvec3 direction(cosine * std::cos(azimuth), cosine * std::sin(azimuth), sine);
              sum += slab_transmittance(extinction_per_m * voxels.march_m({at_m, z_m}, direction));
            }
            return sum / 4;
          };
          const Parts seen = parts_at(values, x, y, layer);
          above.push_back(seen.above), marched_above.push_back(seen_along(0.75, 0.5));
          below.push_back(seen.below), marched_below.push_back(0.5 * (seen_along(-0.25, 0.5) + seen_along(-0.75, 0)));
        }
    for (const auto& [seen, marched] : {std::pair(above, marched_above), std::pair(below, marched_below)}) {
      const Likeness like = likeness(seen, marched);
      EXPECT_GT(like.correlation, 0.95) << "shear " << shear_per_s;
      EXPECT_NEAR(like.mean_ratio, 1, 0.05) << "shear " << shear_per_s;
    }
  }
}

// Beneath the clouds, by whether there is one straight above.
TEST_F(AmbientVisibilityTest, AGapSeesMoreOfTheSky) {
  const Cloudscape sky = with_medium(broken_clouds(90, 50));
  const Voxels voxels = voxels_of(DensityExport(stack().shaders, sky, *baked_of(sky), across));
  const std::vector<float> values = visibility(sky);
  double gap = 0, covered = 0;
  int gaps = 0, clouds = 0;
  for (int y = 0; y < across; ++y)
    for (int x = 0; x < across; ++x) {
      const double cloud_m = voxels.march_m({(x + 0.5) * voxels.voxel_m, (y + 0.5) * voxels.voxel_m, 0}, {0, 0, 1});
      const double above = parts_at(values, x, y, 0).above;
      if (cloud_m == 0) gap += above, ++gaps;
      if (cloud_m > 150) covered += above, ++clouds;
    }
  ASSERT_TRUE(gaps > 50 && clouds > 50) << gaps << ", " << clouds;
  EXPECT_GT(gap / gaps, 0.8);
  EXPECT_LT(covered / clouds, 0.4);
}

// In light that is 1 from everywhere a cloud that absorbs nothing cannot be seen, from wherever; one that absorbs is
// darker.
TEST_F(AmbientVisibilityTest, AWhiteFurnaceStaysWhite) {
  for (const Cloudscape& clouds : {full_layer(40), broken_clouds(90, 50)}) {
    Cloudscape sky = without_sun(clouds, 1, 1);
    for (const CameraPose& pose : {CameraPose{{0, 0, 300}, 40, 30, 0}, CameraPose{{0, 0, 4000}, 40, -20, 0},
                                   CameraPose{{0, 0, 1800}, 10, 5, 0}}) {
      const auto radiance = [&](double albedo) {
        sky.medium.single_scattering_albedo = albedo;
        return render(picture(sky, pose, {16, 9}));
      };
      const Frame white = radiance(1), grey = radiance(0.9);
      double seen = 0;
      for (int pixel = 0; pixel < 16 * 9; ++pixel) {
        EXPECT_NEAR(red(white, pixel), 1, 4e-3) << "pixel " << pixel << ", from " << pose.position_m.z;
        EXPECT_LT(red(grey, pixel), 1 - 0.1 * opacity(grey, pixel) + 4e-3) << "a scattering takes a tenth";
        seen += opacity(white, pixel);
      }
      EXPECT_GT(seen, 20);
    }
  }
}

// A closed layer under an even sky, over a black ground: what comes out below is what comes through the slab, and what
// comes out above what does not (notes of the two-stream equations: Bohren 1987).
TEST_F(AmbientVisibilityTest, WhatComesOutOfALayerIsWhatComesThroughAndWhatDoesNot) {
  for (const double depth : {4.0, 16.0, 64.0}) {
    Cloudscape sky = without_sun(with_medium(full_layer(40)), 1, 0);
    sky.medium.extinction_per_m = depth / 2000;
    const auto mean = [&](double altitude_m, double sign) {
      double flux = 0, weight = 0;
      for (const double elevation_deg : {20.0, 45.0, 70.0}) {
        const Frame frame = render(one_beam(sky, {{0, 0, altitude_m}, 0, sign * elevation_deg, 0}));
        const double share = std::sin(radians(2 * elevation_deg));  // of the flux
        flux += share * red(frame), weight += share;
      }
      return flux / weight;
    };
    EXPECT_NEAR(mean(500, 1), slab_transmittance(depth), 0.1) << "depth " << depth;
    EXPECT_NEAR(mean(3500, -1), 1 - slab_transmittance(depth), 0.1) << "depth " << depth;
  }
}

TEST_F(AmbientVisibilityTest, IsBakedOnceForAllStreamsAndSuns) {
  const int before = renderer().ambient_slices();
  for (const double sun_deg : {31.0, 31.0, 47.0}) {
    FrameRequest request = one_ray(broken_clouds(12, sun_deg), {{0, 0, 300}, 40, 30, 0});
    request.cloudscape = std::make_shared<const Cloudscape>([&] {
      Cloudscape sky = *request.cloudscape;
      sky.seed = 77;
      return sky;
    }());
    render(request);
    EXPECT_EQ(renderer().ambient_slices() - before, slices);
  }
  for (const LightModelKind kind : {LightModelKind::in_scatter_volume, LightModelKind::olajos}) {
    Cloudscape sky = broken_clouds(12, 31);
    sky.seed = 78;
    sky.medium.light_model.kind = kind, sky.medium.light_model.volume_resolution = 8;
    render(one_ray(sky, {{0, 0, 300}, 40, 30, 0}));
    EXPECT_EQ(renderer().ambient_slices() - before, slices) << "of a model that has no use for it";
  }
}

TEST_F(AmbientVisibilityTest, IsTheSameWhateverWasBakedBefore) {
  const Cloudscape sky = with_medium(broken_clouds(12, 31));
  Cloudscape other = sky, thicker = sky;
  other.seed = 5, thicker.medium.extinction_per_m = 0.05;
  Baked with;
  bake(with, other), bake(with, thicker);
  EXPECT_EQ(with.densities.slices(), 2 * CloudDensities::layers / CloudDensities::layers_per_slice);
  EXPECT_EQ(values_of(*bake(with, sky)), visibility(sky));
  EXPECT_EQ(with.densities.slices(), 2 * CloudDensities::layers / CloudDensities::layers_per_slice);
  EXPECT_EQ(with.visibilities.slices(), 3 * slices);
  EXPECT_NE(values_of(*bake(with, thicker)), visibility(sky));
}

}  // namespace
}  // namespace cloudscape::render
