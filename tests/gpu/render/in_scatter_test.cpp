// The in-scatter volume in pictures: against the path tracer, and whose light it is.
#include "gpu/trace/traced.h"
#include "tests/height_maps.h"

namespace cloudscape::render {
namespace {

Cloudscape lit_by_volume(Cloudscape sky) {
  sky.medium.light_model.kind = LightModelKind::in_scatter_volume;
  return sky;
}

// Of droplets, beneath a sun and nothing else.
Cloudscape cloud_slab(double optical_depth, double sun_deg) {
  Cloudscape sky = homogeneous(VolumeKind::slab, {0, 0, 1000}, {1000, 1000, 400}, optical_depth / 400);
  sky.medium.phase = {PhaseKind::henyey_greenstein, 0.85};
  sky.sun.azimuth_deg = 0, sky.sun.elevation_deg = sun_deg;
  return lit_by_volume(sky);
}

class InScatterTest : public RenderTest {
 protected:
  // What the march sees over what the path tracer sees, with `side`^2 x 64 paths.
  static double ratio(const Cloudscape& sky, const CameraPose& pose, double width_m = 1, int side = 32) {
    const Measured truth = measured(render(traced_beam(sky, pose, side, 64, width_m)));
    FrameRequest marched = one_beam(sky, pose);
    marched.lens.width_m = width_m;
    EXPECT_LT(truth.error, 0.06 * truth.mean);
    return red(render(marched)) / truth.mean;
  }
};

constexpr CameraPose above{{0, 0, 3000}, 90, -60, 0}, below{{0, 0, 100}, 90, 60, 0};

TEST_F(InScatterTest, SlabsAreAsBrightAsThePathTracerSays) {
  for (const double depth : {2.0, 8.0, 32.0})
    for (const double sun_deg : {70.0, 25.0})
      for (const CameraPose& pose : {above, below}) {
        // Two moments of so narrow a phase function know little of the light behind it, which a thin cloud seen from
        // above is.
        const double off = std::log(ratio(cloud_slab(depth, sun_deg), pose));
        EXPECT_NEAR(off, 0, depth > 2 ? 0.35 : 0.55) << depth << ", sun " << sun_deg << ", from " << pose.position_m.z;
      }
}

// Of these the pictures of `cloudscape bench truth` know nothing: their forward peak takes too many paths there.
TEST_F(InScatterTest, ASlabOfDropletsByMieTheoryToo) {
  Cloudscape sky = cloud_slab(8, 70);
  sky.medium.phase = {PhaseKind::mie};
  for (const CameraPose& pose : {above, below})
    EXPECT_NEAR(std::log(ratio(sky, pose, 1, 96)), 0, 0.3) << "from " << pose.position_m.z;
}

TEST_F(InScatterTest, TheSkyAloneLightsASlab) {
  Cloudscape sky = cloud_slab(8, 45);
  sky.sun.irradiance = glm::dvec3(0);
  sky.medium.ambient = 1;
  sky.sky.kind = SkyKind::uniform, sky.sky.radiance = glm::dvec3(0.5);
  for (const CameraPose& pose : {above, below}) EXPECT_NEAR(ratio(sky, pose), 1, 0.1);
}

TEST_F(InScatterTest, AbsorbingCloudsAreDarkerAsTheTracerSays) {
  Cloudscape sky = cloud_slab(8, 60);
  const double white = red(render(one_beam(sky, above)));
  sky.medium.single_scattering_albedo = 0.9;
  EXPECT_LT(red(render(one_beam(sky, above))), 0.6 * white);
  EXPECT_NEAR(std::log(ratio(sky, above)), 0, 0.35) << "as the white slab";
}

TEST_F(InScatterTest, ABallIsBrightWhereTheSunIsAndDarkBehind) {
  Cloudscape sky = lit_by_volume(ball(200, 8));
  sky.medium.phase = {PhaseKind::henyey_greenstein, 0.85};
  for (const double azimuth_deg : {90.0, 180.0}) {  // the sun beside, and behind the camera, which looks north
    sky.sun.azimuth_deg = azimuth_deg, sky.sun.elevation_deg = 10;
    EXPECT_NEAR(std::log(ratio(sky, {camera_m, 0, 0, 0}, 300)), 0, 0.25) << azimuth_deg;
  }
}

TEST_F(InScatterTest, NoCloudNoTrouble) {
  Cloudscape sky = lit_by_volume(small_clouds());
  sky.medium.extinction_per_m = 0;
  sky.ground.kind = GroundKind::plain;
  const Frame frame = render(picture(sky, {{0, 0, 100}, 0, -10, 0}, {16, 9}));
  for (const float value : frame.radiance_rgba) EXPECT_TRUE(std::isfinite(value));
}

Cloudscape small_lit_clouds(double sun_deg) {
  Cloudscape sky = lit_by_volume(small_clouds());
  sky.medium.light_model.volume_resolution = 16;
  sky.shape.coverage_variation.amount = 0.2;
  sky.sun.elevation_deg = sun_deg;
  return sky;
}

std::vector<float> seen(Renderer& renderer, double sun_deg, bool may_lag = false) {
  FrameRequest request = picture(small_lit_clouds(sun_deg), {{0, 0, 300}, 0, 20, 0}, {24, 14});
  request.light_may_lag = may_lag;
  const Frame frame = renderer.render(request);
  renderer.forget(request.stream);
  return frame.radiance_rgba;
}

TEST_F(InScatterTest, AMovingPictureTakesTheLightThatThereIs) {
  Stack& own = stack();
  const std::vector<float> high = seen(own.renderer, 61), first = seen(own.renderer, 21, true);
  const std::vector<float> exact = seen(own.renderer, 21);
  EXPECT_NE(first, exact) << "in the light of the other sun";
  EXPECT_NE(exact, high);
  EXPECT_EQ(seen(own.renderer, 21, true), exact) << "the right light is there by now";
  EXPECT_EQ(seen(own.renderer, 61), high);
  EXPECT_EQ(seen(own.renderer, 33, true).size(), high.size());
}

// A program of its own, with a folder of bakes.
struct Kept : OwnStackTest {
  HeightMapFolder folder;
  template <class Use>
  void with_a_new_program(const Use& use) {
    gpu::Context context({});
    gpu::ShaderLibrary shaders;
    bake::BakeStore bakes(context, shaders, bake::BakeCache(folder.path(), 1 << 28), std::uint64_t{1} << 28);
    Renderer renderer(context, shaders, bakes);
    use(renderer);
  }
  std::vector<float> in_a_new_program(double sun_deg) {
    std::vector<float> picture;
    with_a_new_program([&](Renderer& renderer) { picture = seen(renderer, sun_deg); });
    return picture;
  }
  long light_files() const {
    return std::count_if(std::filesystem::directory_iterator(folder.path()), {},
                         [](const auto& entry) { return entry.path().extension() == ".light"; });
  }
};

// A sun that has moved: frames whose lights are still those of the sun before would have light solved that no sun has.
TEST_F(Kept, AMovingPictureSolvesTheLightOfTheSunThatItShows) {
  with_a_new_program([&](Renderer& renderer) {
    FrameRequest request = picture(small_lit_clouds(61), {{0, 0, 300}, 0, 20, 0}, {32, 16});
    request.content = FrameContent::display;
    request.quality.reuse = 16;
    request.stream = next_stream();
    renderer.render(request);
    EXPECT_EQ(light_files(), 1);
    request.cloudscape = std::make_shared<const Cloudscape>(small_lit_clouds(21));
    request.light_may_lag = true;
    for (int frame = 0; frame < 1000 && light_files() < 2; ++frame) renderer.render(request);
    renderer.forget(request.stream);
    seen(renderer, 21);
  });
  EXPECT_EQ(light_files(), 2) << "that of either sun, and no other";
}

// The first picture of a stream does not wait for all levels of the light: one of them is not far off.
TEST_F(Kept, TheFirstMovingPictureIsInADraftOfTheLight) {
  std::vector<float> draft, exact, later;
  with_a_new_program([&](Renderer& renderer) {
    draft = seen(renderer, 21, true), exact = seen(renderer, 21), later = seen(renderer, 21, true);
  });
  EXPECT_EQ(later, exact) << "by now all of it is there";
  double off = 0, sum = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) off += std::abs(draft[i] - exact[i]), sum += std::abs(exact[i]);
  EXPECT_LT(off, 0.05 * sum);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().extension() == ".light") std::filesystem::remove(entry.path());
  EXPECT_EQ(in_a_new_program(21), exact) << "what was shown before changes no picture";
}

TEST_F(Kept, LightFromTheDiskIsTheSame) {
  const std::vector<float> solved = in_a_new_program(30);
  EXPECT_EQ(light_files(), 1);
  EXPECT_EQ(in_a_new_program(30), solved);
  EXPECT_EQ(light_files(), 1);
  EXPECT_NE(in_a_new_program(31), solved);
  EXPECT_EQ(light_files(), 2);
}

}  // namespace
}  // namespace cloudscape::render
