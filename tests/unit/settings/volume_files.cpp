// Documents that name a volume's file: bare names of the kind's own type, and no more texels than the server allows.
#include "core/bake_size.h"
#include "settings/cloudscape_json.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using testing::HasSubstr;

Cloudscape parsed(const std::string& volume) { return parse_cloudscape(R"({"volume": )" + volume + "}", "sky.json"); }
std::string sentence(const std::string& volume) {
  return refusal([&] { parsed(volume); }).sentence;
}
std::string named(const std::string& kind, const std::string& file) {
  return R"({"kind": ")" + kind + R"(", "grid": {"file": ")" + file + R"("}})";
}

TEST(VolumeFileNames, AreBareAndOfTheirKind) {
  EXPECT_EQ(parsed(named("vdb", "cloud.vdb")).volume.grid.file, "cloud.vdb");
  EXPECT_EQ(parsed(named("grid", "cloud.raw")).volume.kind, VolumeKind::grid);
  EXPECT_EQ(parsed(named("grid", "a b..exr")).volume.grid.file, "a b..exr");
  for (const char* file : {"", "cloud.raw", "../cloud.vdb", "/tmp/cloud.vdb", "a/cloud.vdb", "a\\\\cloud.vdb", ".vdb",
                           ".hidden.vdb", "cloud.vdb.gz", "cl\\u0000oud.vdb"})
    EXPECT_THAT(sentence(named("vdb", file)), HasSubstr("/volume/grid/file is")) << file;
  for (const char* file : {"", "cloud.vdb", "../cloud.raw", "cloud.png"})
    EXPECT_THAT(sentence(named("grid", file)), HasSubstr("the bare name of a .raw or .exr file")) << file;
}

TEST(VolumeFileNames, MayStandUnusedButNotPointElsewhere) {
  EXPECT_EQ(parsed(named("noise", "cloud.vdb")).volume.kind, VolumeKind::noise);
  EXPECT_EQ(parsed(named("noise", "")).volume.kind, VolumeKind::noise);
  EXPECT_THAT(sentence(named("noise", "../cloud.vdb")), HasSubstr("bare name"));
}

TEST(VolumeFiles, TakeTwoBytesAVoxel) {
  const auto bytes = [](const std::string& volume) { return shape_bytes(parsed(volume)); };
  EXPECT_EQ(bytes(R"({"kind": "grid", "grid": {"file": "a.raw", "size": [512, 7, 3]}})"), 2u * 512 * 7 * 3);
  EXPECT_EQ(bytes(R"({"kind": "vdb", "grid": {"file": "a.vdb", "resolution": 100}})"), 2u * 100 * 100 * 100);
  EXPECT_THAT(sentence(R"({"kind": "grid", "grid": {"file": "a.raw", "size": [513, 1, 1]}})"),
              HasSubstr("/volume/grid/size/0 is 513: must be within [1, 512]"));
}

TEST(VolumeFiles, ThatAreTooLargeAreRefusedByTheirOwnKey) {
  const auto over = [](const std::string& volume) {
    return refusal([&] { check_bake(parsed(volume), 128, "/cloudscape"); });
  };
  const Refusal vdb = over(R"({"kind": "vdb", "grid": {"file": "a.vdb", "resolution": 512}})");
  EXPECT_EQ(vdb.pointer, "/cloudscape/volume/grid/resolution");
  EXPECT_THAT(vdb.sentence, HasSubstr("max_bake_mib"));
  const Refusal grid = over(R"({"kind": "grid", "grid": {"file": "a.raw", "size": [512, 512, 400]}})");
  EXPECT_EQ(grid.pointer, "/cloudscape/volume/grid/size");
  EXPECT_THAT(grid.sentence, HasSubstr("is 512x512x400, whose textures take"));
}

}  // namespace
}  // namespace cloudscape::settings
