// Layers of a document: how they are read, where they may lie, and what of a document is layered.
#include "core/bake_size.h"
#include "settings/cloudscape_json.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using testing::HasSubstr;

Cloudscape parsed(const std::string& text) { return parse_cloudscape(text, "sky.json"); }
std::string sentence(const std::string& text) {
  return refusal([&] { parsed(text); }).sentence;
}
std::string with_layer(const std::string& layer) { return R"({"layers": [)" + layer + "]}"; }

TEST(DocumentLayers, AreReadAndWritten) {
  const Cloudscape sky = parsed(R"({
    "shape": {"top_m": 1800, "density": 0.9},
    "layers": [{}, {"bottom_m": 2500, "noise": {"worley_mix": 0.5, "frequency": 32, "octaves": 2}, "height_rise": 8,
                    "height_fall": 1, "coverage": 0.6, "density": 0.3}]})");
  EXPECT_EQ(sky.shape.top_m, 1800);
  EXPECT_EQ(sky.shape.density, 0.9);
  ASSERT_EQ(sky.layers.size(), 2U);
  EXPECT_EQ(sky.layers[0], Layer{});
  EXPECT_EQ(sky.layers[1].bottom_m, 2500);
  EXPECT_EQ(sky.layers[1].top_m, std::nullopt);
  EXPECT_EQ(sky.layers[1].noise.frequency, 32);
  EXPECT_EQ(sky.layers[1].noise.gain, LayerNoise{}.gain);
  EXPECT_EQ(sky.layers[1].density, 0.3);
  EXPECT_EQ(parsed(to_json(sky)), sky);
}

TEST(DocumentLayers, AreFourAtMost) {
  EXPECT_EQ(parsed(with_layer("{},{},{},{}")).layers.size(), 4U);
  EXPECT_EQ(sentence(with_layer("{},{},{},{},{}")), "/layers has 5 elements: must have at most 4");
  EXPECT_EQ(sentence(with_layer(R"({"coverage": 2})")), "/layers/0/coverage is 2: must be within [0, 1]");
  EXPECT_THAT(sentence(with_layer(R"({"noise": {"weight": 1}})")), HasSubstr("/layers/0/noise/weight is not a known"));
}

TEST(DocumentLayers, LieWithinTheVolume) {
  constexpr const char* within =
      ": must be an altitude of the volume, from 1000 to 3000 m (volume.origin_m, volume.size_m)";
  EXPECT_EQ(sentence(with_layer(R"({}, {"bottom_m": 900})")), "/layers/1/bottom_m is 900" + std::string(within));
  EXPECT_EQ(sentence(with_layer(R"({"top_m": 3000.5})")), "/layers/0/top_m is 3000.5" + std::string(within));
  EXPECT_EQ(sentence(R"({"shape": {"top_m": 900}})"), "/shape/top_m is 900" + std::string(within));
  EXPECT_NO_THROW(parsed(with_layer(R"({"bottom_m": 1000, "top_m": 3000})")));
}

TEST(DocumentLayers, AreTwoTexelsThick) {
  EXPECT_EQ(sentence(with_layer(R"({"bottom_m": 2000, "top_m": 2031})")),
            "/layers/0 lies from 2000 to 2031 m: must be at least 31.25 m thick, two texels of the volume "
            "(volume.size_m, volume.resolution)");
  EXPECT_THAT(sentence(with_layer(R"({"bottom_m": 2500, "top_m": 2000})")), HasSubstr("lies from 2500 to 2000 m"));
  EXPECT_THAT(sentence(R"({"shape": {"bottom_m": 2990}})"), HasSubstr("/shape lies from 2990 to 3000 m"));
  EXPECT_NO_THROW(parsed(with_layer(R"({"bottom_m": 2000, "top_m": 2031.25})")));
}

TEST(DocumentLayers, HaveNoiseThatTheTexelsCanHold) {
  EXPECT_EQ(sentence(with_layer(R"({"noise": {"frequency": 64, "octaves": 3}})")),
            "/layers/0/noise has 256 cells a tile in its last octave (frequency * lacunarity^(octaves - 1)): must be "
            "at most volume.resolution, 128");
}

TEST(DocumentLayers, AreOfNoise) {
  EXPECT_EQ(sentence(R"({"volume": {"kind": "sphere"}, "layers": [{}]})"),
            "/layers has 1 element: must be empty where volume.kind is sphere, since layers are of noise");
  EXPECT_NO_THROW(parsed(R"({"volume": {"kind": "sphere"}, "layers": []})"));
}

TEST(DocumentLayers, TakeTwoNumbersOfSixteenBits) {
  EXPECT_FALSE(is_layered(parsed("{}")));
  EXPECT_TRUE(is_layered(parsed(with_layer("{}"))));
  EXPECT_TRUE(is_layered(parsed(R"({"shape": {"density": 0.5}})")));
  EXPECT_EQ(shape_bytes(parsed(with_layer("{}"))), 4U * 128 * 128 * 128);
  Cloudscape sky = parsed(R"({"volume": {"format": "r16f", "resolution": 512}, "layers": [{}]})");
  EXPECT_EQ(shape_format(sky), ShapeFormat::rg16f);
  EXPECT_EQ(refusal<OverLimit>([&] { check_bake(sky, 100, ""); }).sentence,
            "/volume/resolution is 512 in rg16f, whose textures take 512.375 MiB: this server's limit is 100 "
            "(max_bake_mib); lower volume.resolution");
}

}  // namespace
}  // namespace cloudscape::settings
