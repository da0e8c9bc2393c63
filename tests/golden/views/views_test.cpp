// Small pictures of every preset and of a few other views, against tests/golden/expected/*.png.
//
// To make the expected pictures after a change that is meant to be seen (look at them before committing):
//   CLOUDSCAPE_GOLDEN_UPDATE=1 ctest --preset dev -L golden
// A failure leaves actual, expected and difference (eight times as strong) in golden/ of the build folder.
#include <gtest/gtest.h>

#include <cstdlib>

#include "golden.h"
#include "render/renderer.h"
#include "settings/cloudscape_json.h"
#include "settings/still_request.h"

namespace cloudscape::golden {
namespace {

namespace fs = std::filesystem;

// A view passes if no channel is further off than `largest` and all together no further than `mean`, in steps of 8
// bits.
struct View {
  const char* name;
  const char* cloudscape;  // a preset, a document of tests/golden/documents, or still:NAME for that of a named still
  int largest;
  double mean;
  const char* reason;  // of the two numbers
  void (*change)(FrameRequest& request) = nullptr;
};

void PrintTo(const View& view, std::ostream* out) { *out << view.name; }

constexpr const char* edges =
    "largest: the march may enter a thin edge one step earlier on another device, in a few pixels; mean: those pixels "
    "are under a hundredth of the picture, and the rest rounds to the same step or its neighbour";
constexpr const char* closed_form =
    "no noise and no step that a device may take otherwise: only rounding, one step here and there";

const View views[] = {
    {"alpine-morning", "alpine-morning", 24, 0.5, edges},
    {"fair-weather-cumulus", "fair-weather-cumulus", 24, 0.5, edges},
    {"mountain-lakes", "mountain-lakes", 24, 0.5, edges},
    {"ocean-evening", "ocean-evening", 24, 0.5, edges},
    {"mackerel-sky", "mackerel-sky", 24, 0.5, edges},
    {"morning-puffs", "morning-puffs", 24, 0.5, edges},
    {"overcast", "overcast", 24, 0.5, edges},
    {"stratocumulus-deck", "stratocumulus-deck", 24, 0.5, edges},
    {"sunset-broken", "sunset-broken", 24, 0.5, edges},
    {"thesis", "thesis", 24, 0.5, edges},
    {"towering-congestus", "towering-congestus", 24, 0.5, edges},
    {"panorama", "fair-weather-cumulus", 24, 0.5, edges,
     [](FrameRequest& request) { request.lens.kind = LensKind::panorama; }},
    {"fisheye-up", "fair-weather-cumulus", 24, 0.5, edges,
     [](FrameRequest& request) {
       request.lens.kind = LensKind::fisheye;
       request.pose.elevation_deg = 90;
     }},
    {"from-an-airliner", "stratocumulus-deck", 24, 0.5, edges,
     [](FrameRequest& request) {
       request.pose = {{0, 0, 12000}, 40, -20, 0};
     }},
    {"blue-hour", "still:blue-hour", 24, 0.5, edges},
    {"moonlight", "still:moonlight", 24, 0.5, edges},
    {"after-an-hour", "sunset-broken", 24, 0.5, edges, [](FrameRequest& request) { request.time_s = 3600; }},
    {"octaves-at-dusk", "stratocumulus-deck", 24, 0.5, edges,
     [](FrameRequest& request) {
       Cloudscape sky = *request.cloudscape;
       sky.medium.light_model.kind = LightModelKind::beer_octaves;
       sky.sun.elevation_deg = 2;
       request.cloudscape = std::make_shared<const Cloudscape>(sky);
     }},
    {"sphere", "sphere.json", 2, 0.05, closed_form},
    {"slab", "slab.json", 2, 0.05, closed_form},
};

std::shared_ptr<const Cloudscape> cloudscape_of(const View& view) {
  const settings::CloudscapeLibrary library{{}};
  const std::string name = view.cloudscape;
  if (name.starts_with("still:"))
    return settings::still_from_document(settings::named_still(name.substr(6)), {}, library, {}).frame.cloudscape;
  return settings::find_cloudscape(
      library, name.ends_with(".json") ? CLOUDSCAPE_SOURCE_DIR "/tests/golden/documents/" + name : name);
}

FrameRequest request_of(const View& view) {
  FrameRequest request;
  request.cloudscape = cloudscape_of(view);
  request.pose = request.cloudscape->view.pose;
  request.lens = request.cloudscape->view.lens;
  request.display = request.cloudscape->view.display;
  request.march = request.cloudscape->view.march;
  request.size_px = {192, 108};
  request.quality = render_quality(Quality::standard);
  request.quality.samples = 4;
  request.stream = 1;
  if (view.change) view.change(request);
  return request;
}

Picture render(const View& view) {
  const gpu::Context context{gpu::ContextOptions{}};
  gpu::ShaderLibrary shaders;
  bake::BakeStore bakes(context, shaders, bake::BakeCache(fs::path(CLOUDSCAPE_GOLDEN_FOLDER) / "bakes", 1U << 30),
                        1U << 30);
  render::Renderer renderer(context, shaders, bakes);
  return picture_of(renderer.render(request_of(view)));
}

// Writes the three pictures, and names them.
std::string leave_pictures(const View& view, const Picture& actual, const Picture& expected) {
  const fs::path folder = CLOUDSCAPE_GOLDEN_FOLDER;
  const auto path = [&](const char* what) { return folder / (std::string(view.name) + "." + what + ".png"); };
  write_png(path("actual"), actual);
  write_png(path("expected"), expected);
  write_png(path("difference"), difference_picture(actual, expected));
  return path("actual").string() + "\n" + path("expected").string() + "\n" + path("difference").string();
}

class Golden : public testing::TestWithParam<View> {};

TEST_P(Golden, LooksAsExpected) {
  const View& view = GetParam();
  const fs::path file = fs::path(CLOUDSCAPE_SOURCE_DIR) / "tests/golden/expected" / (std::string(view.name) + ".png");
  const Picture actual = render(view);
  if (const char* update = std::getenv("CLOUDSCAPE_GOLDEN_UPDATE"); update && std::string(update) == "1")
    return write_png(file, actual);
  const std::optional<Picture> expected = fs::exists(file) ? read_png(file) : std::nullopt;
  ASSERT_TRUE(expected)
      << file.string() << " is missing or no PNG: make it with CLOUDSCAPE_GOLDEN_UPDATE=1 ctest --preset dev -L golden";
  ASSERT_EQ(expected->size_px, actual.size_px) << file.string();
  const Difference difference = compare(actual, *expected);
  if (difference.largest <= view.largest && difference.mean <= view.mean) return;
  ADD_FAILURE() << view.name << " differs by " << difference.largest << " at most (allowed " << view.largest << ") and "
                << difference.mean << " on average (allowed " << view.mean << "; " << view.reason << "):\n"
                << leave_pictures(view, actual, *expected);
}

INSTANTIATE_TEST_SUITE_P(Views, Golden, testing::ValuesIn(views), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(GoldenViews, HoldEveryPreset) {
  for (const auto& entry : settings::CloudscapeLibrary({}).list()) {
    const bool listed =
        std::any_of(std::begin(views), std::end(views), [&](const View& view) { return entry.name == view.name; });
    EXPECT_TRUE(listed) << "the preset " << entry.name << " has no view in " << __FILE__;
  }
}

}  // namespace
}  // namespace cloudscape::golden
