// The same request gives the same bytes, whatever else the renderer does in between, and however it does it.
#include "fixture.h"

namespace cloudscape::render {
namespace {

using Repeat = RenderTest;

FrameRequest still(int samples, ImageSize size_px = {48, 27}) {
  FrameRequest request = picture(small_clouds(), {{0, 0, 500}, 20, 12, 0}, size_px);
  request.content = FrameContent::display;
  request.quality.samples = samples;
  request.quality.float32 = false;
  return request;
}

struct Rendered {
  Frame frame;
  int slices = 0;
};

Rendered render_counted(Renderer& renderer, const FrameRequest& request) {
  Rendered rendered;
  auto job = renderer.begin(request);
  do ++rendered.slices;
  while (!renderer.advance(*job));
  rendered.frame = renderer.collect(renderer.finish(std::move(job)));
  return rendered;
}

TEST_F(Repeat, StillsAreByteEqual) {
  const Frame first = render(still(3));
  EXPECT_EQ(first.samples, 3);
  ASSERT_EQ(first.display_rgba.size(), 48U * 27 * 4);
  EXPECT_TRUE(first.radiance_rgba.empty());
  EXPECT_EQ(render(still(3)).display_rgba, first.display_rgba);
}

TEST_F(Repeat, OtherFramesInBetweenChangeNothing) {
  FrameRequest a = still(3), b = still(2, {64, 40});
  b.pose.azimuth_deg = 200, b.quality.march_divisor = 2;
  b.content = FrameContent::radiance;
  FrameRequest c = still(4);  // of the same size: it shares the pool of targets
  c.pose.elevation_deg = 50;
  const Frame a_alone = render(a), b_alone = render(b), c_alone = render(c);
  auto job_a = renderer().begin(a), job_b = renderer().begin(b), job_c = renderer().begin(c);
  bool a_done = false, b_done = false, c_done = false;
  while (!a_done || !b_done || !c_done) {
    a_done = a_done || renderer().advance(*job_a);
    b_done = b_done || renderer().advance(*job_b);
    c_done = c_done || renderer().advance(*job_c);
  }
  auto pending_a = renderer().finish(std::move(job_a)), pending_b = renderer().finish(std::move(job_b));
  auto pending_c = renderer().finish(std::move(job_c));
  EXPECT_EQ(renderer().collect(std::move(pending_c)).display_rgba, c_alone.display_rgba);
  EXPECT_EQ(renderer().collect(std::move(pending_b)).radiance_rgba, b_alone.radiance_rgba);
  EXPECT_EQ(renderer().collect(std::move(pending_a)).display_rgba, a_alone.display_rgba);
}

TEST_F(Repeat, AnAverageCanBeContinued) {
  FrameRequest whole = still(8), part = still(4);
  whole.content = part.content = FrameContent::radiance;
  const Frame at_once = render(whole);
  const Frame half = renderer().render(part);
  EXPECT_EQ(half.samples, 4);
  part.first_sample = 4;
  const Frame both = renderer().render(part);
  EXPECT_EQ(both.samples, 8);
  EXPECT_EQ(both.radiance_rgba, at_once.radiance_rgba);
  EXPECT_EQ(both.depth_m, at_once.depth_m);
  EXPECT_NE(half.radiance_rgba, at_once.radiance_rgba);
}

TEST_F(Repeat, AnAverageThatIsNotThereStartsAnew) {
  FrameRequest request = still(4);
  const Frame fresh = render(request);
  request.first_sample = 4;
  const Frame continued = render(request);
  EXPECT_EQ(continued.samples, 4);
  EXPECT_EQ(continued.display_rgba, fresh.display_rgba);
}

TEST_F(Repeat, ForgettingAStreamFreesItsBytes) {
  for (const StreamId stream : renderer().remembered()) renderer().forget(stream);
  ASSERT_EQ(renderer().history_bytes(), 0U);
  const FrameRequest a = still(1), b = still(1, {16, 16});
  renderer().render(a);
  renderer().render(b);
  const std::size_t bytes_a = 48 * 27 * (16 + 4), bytes_b = 16 * 16 * (16 + 4);
  EXPECT_EQ(renderer().history_bytes(), bytes_a + bytes_b);
  EXPECT_EQ(renderer().history_bytes(b.stream), bytes_b);
  EXPECT_EQ(renderer().history_bytes(b.stream + 1), 0U);
  EXPECT_EQ(renderer().remembered(), (std::vector<StreamId>{a.stream, b.stream}));
  renderer().forget(a.stream);
  EXPECT_EQ(renderer().history_bytes(), bytes_b);
  renderer().forget(b.stream);
  renderer().forget(b.stream);
  EXPECT_EQ(renderer().history_bytes(), 0U);
}

TEST_F(Repeat, AnAbandonedFrameLeavesTheRendererWhole) {
  const Frame whole = render(still(2));
  auto job = renderer().begin(still(2));
  renderer().advance(*job);
  renderer().abandon(std::move(job));
  EXPECT_EQ(render(still(2)).display_rgba, whole.display_rgba);
}

TEST_F(Repeat, DividedMarchesCoverOddSizes) {
  FrameRequest request = still(1, {47, 29});
  request.content = FrameContent::radiance;
  for (const int divisor : {1, 2, 4}) {
    request.quality.march_divisor = divisor;
    const Frame frame = render(request);
    ASSERT_EQ(frame.depth_m.size(), 47U * 29);
    for (const float value : frame.radiance_rgba) ASSERT_TRUE(std::isfinite(value)) << divisor;
  }
}

// The mean of neighbours takes noise away and leaves alone what is even.
TEST_F(Repeat, SmoothingKeepsTheMean) {
  FrameRequest request = still(1, {48, 30});
  request.content = FrameContent::radiance;
  const auto roughness_and_mean = [&](bool smooth) {
    request.quality.smooth = smooth;
    const Frame frame = render(request);
    double rough = 0, mean = 0;
    for (int i = 1; i < 48 * 30; ++i) {
      rough += std::abs(opacity(frame, i) - opacity(frame, i - 1));
      mean += opacity(frame, i) / (48 * 30);
    }
    return std::pair(rough, mean);
  };
  const auto [rough, mean] = roughness_and_mean(false);
  const auto [smoother, same_mean] = roughness_and_mean(true);
  EXPECT_LT(smoother, 0.95 * rough);  // what is left are the edges of clouds
  EXPECT_NEAR(same_mean, mean, 0.01);
}

TEST_F(Repeat, ThePoolKeepsFewTargets) {
  TargetPool pool;
  for (int side = 1; side <= 10; ++side) pool.release(pool.acquire({side, side}, {}));
  EXPECT_EQ(pool.size(), TargetPool::most_free);
  auto again = pool.acquire({10, 10}, {});
  EXPECT_EQ(pool.size(), TargetPool::most_free - 1) << "the last one released is used again";
}

// Forty columns of 80 on each side of a tile's edge; of a picture of many tiles the first and the last are equal.
TEST_F(Repeat, RaysLieEvenlyOverTiles) {
  TargetPool pool;
  const auto small = pool.acquire({80, 45}, {}, RayPlaces::over_tiles),
             large = pool.acquire({300, 128}, {}, RayPlaces::over_tiles);
  EXPECT_EQ(small->march_origin, glm::ivec2(24, 42));
  EXPECT_EQ(large->march_origin, glm::ivec2(10, 0));
  EXPECT_EQ(small->march_size, (ImageSize{80, 45}));
  EXPECT_EQ(small->march_radiance.width(), 104);
  EXPECT_EQ(pool.acquire({80, 45}, {})->march_origin, glm::ivec2(0));
}

using Executions = OwnStackTest;

// Compute dispatches against full-screen triangles, one after the other in one process.
TEST_F(Executions, GiveTheSamePicture) {
  FrameRequest display = still(2), radiance = still(2);
  radiance.content = FrameContent::radiance;
  radiance.quality.float32 = true;
  std::vector<Frame> frames;
  for (const auto execution : {gpu::PassExecution::compute, gpu::PassExecution::fragment}) {
    Stack own(execution);
    frames.push_back(own.renderer.render(display));
    frames.push_back(own.renderer.render(radiance));
    EXPECT_EQ(own.context.gl_errors(), 0);
  }
  ASSERT_EQ(frames[0].display_rgba.size(), frames[2].display_rgba.size());
  for (std::size_t i = 0; i < frames[0].display_rgba.size(); ++i)
    ASSERT_LE(std::abs(frames[0].display_rgba[i] - frames[2].display_rgba[i]), 1) << "byte " << i;
  for (std::size_t i = 0; i < frames[1].radiance_rgba.size(); ++i)
    ASSERT_NEAR(frames[1].radiance_rgba[i], frames[3].radiance_rgba[i], 1e-3) << "number " << i;
}

// A renderer that knows no speed yet takes the picture in one slice; then it has measured, and takes smaller ones.
TEST_F(Executions, OfAnySizeOfSlicesGiveTheSameBytes) {
  Stack own;
  FrameRequest tall = still(1, {128, 1600});
  tall.lens.kind = LensKind::panorama;
  own.bakes.get(bake::bake_recipe(*tall.cloudscape));
  const Rendered before = render_counted(own.renderer, tall);
  const Rendered after = render_counted(own.renderer, tall);
  if (before.slices == after.slices) GTEST_SKIP() << "this device takes such a picture in one slice";
  EXPECT_EQ(before.frame.display_rgba, after.frame.display_rgba);
}

using Blocks = RenderTest;

// What the driver makes of shaders/shared against what the compiler makes of it.
TEST_F(Blocks, LieAsTheDriverLaysThem) {
  gpu::ShaderLibrary& shaders = stack().shaders;
  const gpu::ScreenPass march(stack().context, shaders, "render/march.glsl",
                              {gpu::Format::rgba16f, gpu::Format::rg32f});
  EXPECT_EQ(march.program().block_offsets("FrameBlock"), FrameBlock::offsets());
  EXPECT_EQ(march.program().block_offsets("CloudBlock"), CloudBlock::offsets());
  const gpu::ScreenPass bloom(stack().context, shaders, "render/bloom_vertical.glsl", {gpu::Format::rgba32f});
  EXPECT_EQ(bloom.program().block_offsets("BloomBlock"), BloomBlock::offsets());
  const gpu::ScreenPass scene(stack().context, shaders, "render/scene_land.glsl",
                              {gpu::Format::rgba16f, gpu::Format::r32f});
  EXPECT_EQ(scene.program().block_offsets("TerrainBlock"), TerrainBlock::offsets());
  const gpu::ScreenPass water(stack().context, shaders, "render/scene_water.glsl",
                              {gpu::Format::rgba16f, gpu::Format::r32f});
  EXPECT_EQ(water.program().block_offsets("WaterBlock"), WaterBlock::offsets());
  const gpu::ScreenPass sky(stack().context, shaders, "render/sky_view.glsl",
                            {gpu::Format::rgba32f, gpu::Format::rgba32f});
  EXPECT_EQ(sky.program().block_offsets("SkyBlock"), SkyBlock::offsets());
  const gpu::VolumePass sun(shaders, "render/sun_depth.comp");
  EXPECT_EQ(sun.program().block_offsets("SunBlock"), SunBlock::offsets());
  const gpu::ScreenPass noise(stack().context, shaders, "bake/terrain.glsl", {gpu::Format::r32f});
  EXPECT_EQ(noise.program().block_offsets("TerrainBakeBlock"), bake::TerrainBakeBlock::offsets());
  const gpu::VolumePass shape(shaders, "bake/shape.comp");
  EXPECT_EQ(shape.program().block_offsets("BakeBlock"), bake::BakeBlock::offsets());
  const gpu::VolumePass density(shaders, "render/density.comp");
  EXPECT_EQ(density.program().block_offsets("DensityBlock"), DensityBlock::offsets());
}

}  // namespace
}  // namespace cloudscape::render
