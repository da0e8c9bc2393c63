// The switchable techniques of the march (Olajos 2.4, 2.5): each does what it says, and nothing else.
#include "layered_clouds.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using Technique = RenderTest;

// A layer with air in it, fine enough that the structure leaves air free.
Cloudscape scattered_clouds(double variation = 0) {
  Cloudscape sky = small_clouds();
  sky.volume.resolution = 64;
  sky.shape.coverage = 0.2;
  sky.shape.coverage_variation.amount = variation;
  sky.ground.kind = GroundKind::none;
  return sky;
}

// What clear air is crossed by.
enum class Across { distances, structure, small_steps };

FrameRequest small_steps(const Cloudscape& sky, const CameraPose& pose, Across across) {
  FrameRequest request = picture(sky, pose, {48, 27});
  request.march.distance_field = across == Across::distances;
  request.march.structure = across == Across::structure;
  request.march.step_m = 10;
  request.march.max_steps = 16384;
  request.march.max_distance_m = 30000;
  return request;
}

double difference(const Frame& a, const Frame& b, int pixel) {
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t at = 4 * static_cast<std::size_t>(pixel) + i;
    largest = std::max<double>(largest, std::abs(a.radiance_rgba[at] - b.radiance_rgba[at]));
  }
  return largest;
}

int pixels_of(const Frame& frame) { return static_cast<int>(frame.depth_m.size()); }

const CameraPose below{{500, 200, 60}, 30, 25, 0}, above{{0, 0, 5000}, 60, -20, 0}, inside{{900, 700, 1450}, 100, 3, 0},
    grazing{{0, 0, 2590}, 200, -0.5, 0}, along_the_base{{0, 0, 1010}, 300, 0.5, 0};

// Small steps lie at the same places however clear air is crossed, so that only a cloud that was missed can differ.
// The threshold leaves room for the rounding of distances.
void expect_no_cloud_is_missed(Across across, const auto& document, const auto& render) {
  for (const double variation : {0.0, 0.6}) {
    for (const CameraPose& pose : {below, above, inside, grazing, along_the_base}) {
      const Cloudscape sky = document(variation);
      const Frame with = render(small_steps(sky, pose, across)),
                  without = render(small_steps(sky, pose, Across::small_steps));
      double sum = 0, cloud = 0;
      for (int i = 0; i < pixels_of(with); ++i) {
        EXPECT_LT(std::abs(opacity(with, i) - opacity(without, i)), 0.02)
            << "altitude " << pose.position_m.z << ", " << i;
        sum += difference(with, without, i);
        cloud += opacity(without, i);
      }
      EXPECT_LT(sum / pixels_of(with), 1e-3) << "from an altitude of " << pose.position_m.z << " m";
      EXPECT_GT(cloud / pixels_of(with), 0.02) << "nothing to miss";
    }
  }
}

Cloudscape scattered_layers(double variation) {
  Cloudscape sky = layered_clouds();
  sky.shape.coverage_variation.amount = variation;
  sky.ground.kind = GroundKind::none;
  return sky;
}

TEST_F(Technique, StructureMissesNoCloud) {
  expect_no_cloud_is_missed(Across::structure, scattered_clouds, render);
  expect_no_cloud_is_missed(Across::structure, scattered_layers, render);
}
TEST_F(Technique, DistanceFieldMissesNoCloud) {
  expect_no_cloud_is_missed(Across::distances, scattered_clouds, render);
  expect_no_cloud_is_missed(Across::distances, scattered_layers, render);
}

// Steps are bounded, so that what a ray sees tells how many it took.
TEST_F(Technique, DistancesTakeFewerStepsThanTheStructure) {
  const Cloudscape sky = scattered_clouds(0.3);
  const auto seen = [&](Across across, int steps) {
    FrameRequest request = small_steps(sky, {{900, 700, 1900}, 100, -1, 0}, across);
    request.march.max_steps = steps;
    const Frame frame = render(request);
    double cloud = 0;
    for (int i = 0; i < pixels_of(frame); ++i) cloud += opacity(frame, i) / pixels_of(frame);
    return cloud;
  };
  const double all = seen(Across::small_steps, 16384);
  EXPECT_GT(seen(Across::distances, 120), 1.4 * seen(Across::structure, 120));
  EXPECT_NEAR(seen(Across::distances, 16384), all, 0.01 * all);
}

TEST_F(Technique, LargeStepsAreNeverLongerThanThePaddingMakesSafe) {
  const Cloudscape sky = scattered_clouds();
  const bake::BakedCloudscape& baked = *stack().bakes.get(bake::bake_recipe(sky));
  const double cell_m = 8000.0 / 64, longest_m = 2 * bake::structure_padding * cell_m;
  FrameRequest request = small_steps(sky, below, Across::structure);
  request.march.step_m.reset();
  EXPECT_NEAR(cloud_block(request, baked).structure.x, longest_m, 0.05 * longest_m);
  request.march.large_step_m = 100;
  EXPECT_FLOAT_EQ(cloud_block(request, baked).structure.x, 100);
  request.march.step_m = 30;
  EXPECT_FLOAT_EQ(cloud_block(request, baked).structure.x, 90) << "a whole number of small steps";
  request.march.large_step_m = 1e5;
  EXPECT_LE(cloud_block(request, baked).structure.x, longest_m * 1.05);
  request.march.structure = false;
  EXPECT_EQ(cloud_block(request, baked).structure.x, 0);
}

TEST_F(Technique, LargeStepsAreShorterWhereTheLandBendsTheTile) {
  const Cloudscape even = scattered_clouds(), bent = scattered_clouds(0.6);
  const bake::BakedCloudscape& baked = *stack().bakes.get(bake::bake_recipe(even));
  const CloudBlock straight = cloud_block(small_steps(even, below, Across::structure), baked);
  const CloudBlock turned = cloud_block(small_steps(bent, below, Across::structure), baked);
  EXPECT_LT(turned.structure.x, straight.structure.x);
  EXPECT_EQ(straight.structure.y, 0);
  EXPECT_GT(turned.structure.y, 0);
}

TEST_F(Technique, AdaptiveStepsGrowFromTheirBeginningOn) {
  const Cloudscape sky = scattered_clouds();
  const auto pictured = [&](bool adaptive, double start_m, double growth) {
    FrameRequest request = small_steps(sky, below, Across::structure);
    request.march.adaptive_step = adaptive;
    request.march.adaptive_start_m = start_m;
    request.march.adaptive_growth = growth;
    return render(request).radiance_rgba;
  };
  const auto even = pictured(false, 0, 1);
  EXPECT_EQ(pictured(true, 40000, 1), even) << "it begins behind the last cloud";
  EXPECT_EQ(pictured(true, 0, 0), even) << "no growth";
  EXPECT_NE(pictured(true, 0, 0.2), even);
}

// How far off a picture's opacity is, on average: pixel by pixel less the neighbour's error, and in blocks of 8x9
// pixels.
struct Roughness {
  double of_neighbours = 0, of_blocks = 0;
};

Roughness roughness(const Frame& coarse, const Frame& fine, ImageSize size) {
  Roughness found;
  const auto error = [&](int x, int y) {
    return opacity(coarse, y * size.width + x) - opacity(fine, y * size.width + x);
  };
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x + 1 < size.width; ++x) found.of_neighbours += std::abs(error(x, y) - error(x + 1, y));
  for (int top = 0; top < size.height; top += 9)
    for (int left = 0; left < size.width; left += 8) {
      double sum = 0;
      for (int i = 0; i < 72; ++i) sum += error(left + i % 8, top + i / 8);
      found.of_blocks += std::abs(sum);
    }
  return found;
}

// Olajos' figure 2.10: a thin even cloud, seen at a slant and in steps that are far too long, shows bands; a random
// first step makes noise of them.
TEST_F(Technique, RandomFirstStepTurnsBandsIntoNoise) {
  Cloudscape sky = homogeneous(VolumeKind::gaussian, {-4000, 2000, 500}, glm::dvec3(8000), 1e-4);
  const CameraPose pose{{0, -3000, 1500}, 0, 8, 0};
  const ImageSize size{64, 36};
  FrameRequest request = picture(sky, pose, size);
  request.march.max_steps = 256;
  const Frame fine = render(request);
  request.march.max_steps = 2;
  const Frame noisy = render(request);
  request.march.random_first_step = false;
  const Frame banded = render(request);
  // Bands are smooth and wrong; noise is rough and right on average.
  const Roughness bands = roughness(banded, fine, size), noise = roughness(noisy, fine, size);
  EXPECT_GT(noise.of_neighbours, 3 * bands.of_neighbours);
  EXPECT_LT(noise.of_blocks, 0.3 * bands.of_blocks);
}

// What few samples of the light get wrong differs from pixel to pixel, and averages out over eight neighbours in a row.
// It once went with the distance, and showed as contours on the clouds' undersides.
TEST_F(Technique, FewSamplesOfTheLightShowAsNoiseAndNotAsContours) {
  Cloudscape sky;
  sky.seed = 7;
  sky.volume.origin_m = {0, 0, 1100}, sky.volume.size_m = {8000, 8000, 1900};
  sky.shape.coverage = 0.3, sky.shape.height_fall = 1.4;
  sky.shape.coverage_variation = {0.2, 25000};
  sky.sun.azimuth_deg = 110, sky.sun.elevation_deg = 46;
  sky.medium.ambient = 0;
  sky.ground.kind = GroundKind::none, sky.sky.kind = SkyKind::none;
  FrameRequest request = picture(sky, {{0, 0, 350}, 0, 25, 0}, {96, 54});
  request.lens.vertical_fov_deg = 9;
  request.quality = {.max_steps = 256, .step_m = 22, .step_growth = 0.016, .light_steps = 6, .samples = 8};
  const Frame few = render(request);
  request.march.light_steps = 96;
  const Frame many = render(request);
  // By how much the mean of eight pixels in a row differs from those above and below, less what the right picture has.
  const auto row_error = [&](int block, int y) {
    double sum = 0;
    for (int i = 0; i < 8; ++i) sum += (red(few, y * 96 + 8 * block + i) - red(many, y * 96 + 8 * block + i)) / 8;
    return sum;
  };
  double contours = 0, light = 0;
  for (int block = 0; block < 12; ++block)
    for (int y = 1; y + 1 < 54; ++y) {
      contours += std::abs(row_error(block, y) - 0.5 * (row_error(block, y - 1) + row_error(block, y + 1)));
      light += red(many, y * 96 + 8 * block);
    }
  EXPECT_GT(light, 1);
  EXPECT_LT(contours / light, 0.016) << "0.010 by noise alone, 0.024 with the contours";
}

// Far clouds in long steps, and near where the structure's cells begin: averaged over the samples, their steps are not
// to be seen. They once were, as ribs: the first step was random by a share of the short one at the camera only.
TEST_F(Technique, FarStepsLeaveNoRibs) {
  Cloudscape sky = scattered_clouds();
  sky.volume.resolution = 128, sky.volume.size_m = {12000, 12000, 4600};
  sky.shape.towers = {{.center = {0.42, 0.6}, .radius = 0.08, .top = 1, .strength = 0.8}};
  sky.sun.azimuth_deg = 250, sky.sun.elevation_deg = 32;
  FrameRequest request = picture(sky, {{5200, -800, 1500}, 355, 17, 0}, {64, 36});
  request.lens.vertical_fov_deg = 12;
  request.quality = render_quality(Quality::standard);
  request.quality.samples = 64;
  const Frame coarse = render(request);
  request.march.step_m = 10, request.march.max_steps = 2000;
  const Frame fine = render(request);
  double ribs = 0, light = 0;
  for (int i = 64; i + 64 < pixels_of(fine); ++i) {
    const auto error = [&](int at) { return red(coarse, at) - red(fine, at); };
    ribs += std::abs(error(i) - 0.5 * (error(i - 64) + error(i + 64)));
    light += red(fine, i);
  }
  EXPECT_GT(light, 1);
  EXPECT_LT(ribs / light, 0.05) << "0.036 by noise alone, 0.065 with the ribs";
}

// An opaque cloud without lighting shows the source function itself, whatever the phase function.
TEST_F(Technique, WithoutLightingAllOfTheCloudIsLitAlike) {
  Cloudscape sky = ball(200, 200);
  FrameRequest request = one_ray(sky, {camera_m, 0, 0, 0});
  request.march.lighting = false;
  const double flat = 0.5 / std::numbers::pi;
  EXPECT_NEAR(red(render(request)) / flat, 1, 0.01);
  sky.sun.azimuth_deg = 0;
  sky.medium.light_model.kind = LightModelKind::olajos;
  sky.medium.light_model.olajos_dark = {0.25, 0, 0};
  sky.medium.light_model.olajos_bright = {0.5, 0, 0};
  request = one_ray(sky, {camera_m, 0, 0, 0});
  request.march.lighting = false;
  EXPECT_NEAR(red(render(request)) / (0.25 / std::numbers::pi + 0.5 * flat), 1, 0.01);
}

TEST_F(Technique, LightStepsAndLengthAreTheDocuments) {
  const Cloudscape sky = ball(2000, 3, VolumeKind::gaussian);
  const auto lit = [&](int steps) {
    FrameRequest request = one_ray(sky, {{0, -5000, 1000}, 0, 0, 0});
    request.march.max_steps = 256;
    request.march.light_steps = steps;
    return red(render(request));
  };
  const double fine = lit(128);
  EXPECT_NEAR(lit(64) / fine, 1, 0.01);
  EXPECT_GT(std::abs(lit(1) / fine - 1), 0.02);
  Cloudscape layer = small_clouds();
  FrameRequest near = picture(layer, {{0, 0, 100}, 0, 50, 0}, {24, 16}), far = near;
  near.march.light_length_m = 20;
  far.march.light_length_m = 2000;
  const Frame bright = render(near), dark = render(far);
  double near_sum = 0, far_sum = 0;
  for (int i = 0; i < pixels_of(bright); ++i) near_sum += red(bright, i), far_sum += red(dark, i);
  EXPECT_NEAR(near_sum / far_sum, 1, 0.2) << "what the march does not reach, a volume knows";
  EXPECT_NE(near_sum, far_sum);
}

// A software rasterizer leaves every loop of a shader once they have gone round 65535 times together.
TEST_F(Technique, StepsAreNoMoreThanADeviceGoesThrough) {
  const bake::BakedCloudscape& baked = *stack().bakes.get(bake::bake_recipe(small_clouds()));
  FrameRequest request = small_steps(small_clouds(), below, Across::structure);
  request.march.light_steps = 128;
  const CloudBlock block = cloud_block(request, baked);
  EXPECT_LE(block.steps.z * (block.steps.w + 2), 65535);
  request.march.light_steps = 1;
  EXPECT_EQ(cloud_block(request, baked).steps.z, 16384);
}

TEST_F(Technique, TheMarchEndsAtItsGreatestDistance) {
  const Cloudscape sky = scattered_clouds();
  FrameRequest request = small_steps(sky, inside, Across::structure);
  request.march.max_distance_m = 3000;
  const Frame frame = render(request);
  for (const float depth : frame.depth_m) EXPECT_TRUE(depth <= 3000 || std::isinf(depth)) << depth;
}

}  // namespace
}  // namespace cloudscape::render
