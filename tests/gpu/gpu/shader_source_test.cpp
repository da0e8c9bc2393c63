// Includes, the line map, driver logs, changed files, and the build's check of all shaders. None of it needs a device.
#include "gpu/shader_source.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "fixture.h"
#include "gpu/shader_check.h"

namespace cloudscape::gpu {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string failure_of(const auto& action) {
  try {
    action();
    return "no failure";
  } catch (const Error& error) {
    return error.what();
  }
}

class ShaderSourceTest : public testing::Test {
 protected:
  ShaderSource load(const std::string& path) { return ShaderLibrary(folder_.path()).load(path, "P\n", "E\n"); }
  std::string failure(const std::string& path) {
    return failure_of([&] { load(path); });
  }
  ShaderFolder folder_;
};

TEST_F(ShaderSourceTest, PutsTheVersionFirstAndEachIncludeInOnce) {
  folder_.write("main.glsl", "#include \"lib/a.glsl\"\n  # include \"lib/b.glsl\" // again\nmain\n#include <vector>\n");
  folder_.write("lib/a.glsl", "#include \"lib/b.glsl\"\na");
  folder_.write("lib/b.glsl", "b\r\n");
  EXPECT_EQ(load("main.glsl").text, "#version 450 core\nP\nb\na\nmain\n\nE\n");
}

TEST_F(ShaderSourceTest, KnowsWhereEachLineComesFrom) {
  folder_.write("main.glsl", "one\n#include \"./lib/../a.glsl\"\nthree\n");
  folder_.write("a.glsl", "a one\na two\n");
  const ShaderSource source = load("main.glsl");
  std::vector<std::string> places;
  for (const auto& line : source.lines) places.push_back(line.file + ":" + std::to_string(line.number));
  EXPECT_THAT(places, testing::ElementsAre("(version):1", "(prologue):1", "main.glsl:1", "a.glsl:1", "a.glsl:2",
                                           "main.glsl:3", "(epilogue):1"));
}

TEST_F(ShaderSourceTest, SaysWhoIncludesAMissingFileAndWhichFilesIncludeEachOther) {
  folder_.write("main.glsl", "\n#include \"a.glsl\"\n");
  folder_.write("a.glsl", "\n\n#include \"gone.glsl\"\n");
  EXPECT_EQ(failure("main.glsl"),
            "the shader file 'gone.glsl' is missing: main.glsl:2 includes a.glsl:3 includes gone.glsl");
  folder_.write("gone.glsl", "#include \"a.glsl\"\n");
  EXPECT_EQ(failure("main.glsl"),
            "a shader includes itself: main.glsl:2 includes a.glsl:3 includes gone.glsl:1 includes a.glsl");
  EXPECT_THAT(failure("nothing.glsl"), HasSubstr("'nothing.glsl' is missing"));
}

TEST_F(ShaderSourceTest, ReadsNothingOutsideItsFolder) {
  folder_.write("main.glsl", "#include \"../../../etc/hostname\"\n");
  EXPECT_THAT(failure("main.glsl"), HasSubstr("is missing"));
  folder_.write("main.glsl", "#include \"/etc/hostname\"\n");
  EXPECT_THAT(failure("main.glsl"), HasSubstr("is missing"));
}

TEST_F(ShaderSourceTest, ExplainsTheLogsOfMesaNvidiaAndGlslang) {
  folder_.write("main.glsl", "one\n#include \"lib/a.glsl\"\n");
  folder_.write("lib/a.glsl", "first\nsecond\n");
  const ShaderSource source = load("main.glsl");  // lib/a.glsl:2 is line 5
  EXPECT_EQ(source.explain("0:5(12): error: `x' undeclared\n0:3(1): warning: w"),
            "lib/a.glsl:2: error: `x' undeclared\nmain.glsl:1: warning: w");
  EXPECT_EQ(source.explain("0(5) : error C1008: undefined variable \"x\""),
            "lib/a.glsl:2: error C1008: undefined variable \"x\"");
  EXPECT_EQ(source.explain("ERROR: 0:5: 'x' : undeclared identifier\nWARNING: 0:3: w"),
            "ERROR: lib/a.glsl:2: 'x' : undeclared identifier\nWARNING: main.glsl:1: w");
  EXPECT_EQ(source.explain("error: linking failed\n0:99(1): error: beyond\n0:0(0): error: before"),
            "error: linking failed\n0:99(1): error: beyond\n0:0(0): error: before");
  EXPECT_EQ(source.explain("0:99999999999999999999(1): error: absurd"), "0:99999999999999999999(1): error: absurd");
}

TEST_F(ShaderSourceTest, NoticesChangedAndNewFiles) {
  folder_.write("lib/a.glsl", "a\n");
  ShaderLibrary library(folder_.path());
  EXPECT_FALSE(library.changed());
  const auto later = std::filesystem::last_write_time(folder_.path() / "lib/a.glsl") + std::chrono::seconds(1);
  std::filesystem::last_write_time(folder_.path() / "lib/a.glsl", later);
  EXPECT_TRUE(library.changed());
  EXPECT_FALSE(library.changed());
  folder_.write("b.glsl", "b\n");
  std::filesystem::last_write_time(folder_.path() / "b.glsl", later + std::chrono::seconds(1));
  EXPECT_TRUE(library.changed());
}

TEST_F(ShaderSourceTest, AMissingFolderNamesTheOption) {
  EXPECT_THAT(failure_of([] { ShaderLibrary("/no/such/folder"); }),
              HasSubstr("--shader-dir is '/no/such/folder': must be a folder"));
}

TEST_F(ShaderSourceTest, TheEmbeddedShadersAreTheFilesOfTheTree) {
  ShaderLibrary embedded;
  EXPECT_FALSE(embedded.changed());
  const ShaderLibrary tree(std::filesystem::path(CLOUDSCAPE_SOURCE_DIR) / "shaders");
  EXPECT_THAT(embedded.paths(), testing::Contains("shared/block.glsl"));
  for (const std::string& path : embedded.paths()) EXPECT_EQ(embedded.read(path), tree.read(path)) << path;
}

class ShaderCheckTest : public ShaderSourceTest {
 protected:
  std::string check() {
    return check_shaders(ShaderLibrary(folder_.path()), "/usr/bin/glslangValidator", output_.path());
  }
  void SetUp() override {
    if (!std::filesystem::exists("/usr/bin/glslangValidator")) GTEST_SKIP() << "glslangValidator is not installed";
  }
  ShaderFolder output_;
};

TEST_F(ShaderCheckTest, PassesGoodShadersAndNamesTheLineOfABadOne) {
  folder_.write("render/good.glsl",
                "// targets: rgba16f r32f\n#include \"lib/x.glsl\"\n"
                "PassOutput shade(ivec2 pixel) { return PassOutput(vec4(x()), vec4(1.0)); }\n");
  folder_.write("lib/x.glsl", "float x() { return 1.0; }\n");
  folder_.write("bake/good.comp",
                "layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;\n"
                "layout(binding = 0, r8) writeonly uniform image3D volume;\n"
                "void main() { imageStore(volume, ivec3(0, 0, volume_pass.z_begin), vec4(1)); }\n");
  EXPECT_EQ(check(), "");
  folder_.write("lib/x.glsl", "// x\nfloat x() { return why; }\n");
  EXPECT_THAT(check(), AllOf(HasSubstr("lib/x.glsl:2:"), HasSubstr("'why'")));
}

TEST_F(ShaderCheckTest, FindsWhatOnlyOneExecutionCannotDo) {
  folder_.write("render/bad.glsl",
                "// targets: r32f\nPassOutput shade(ivec2 p) { return PassOutput(dFdx(vec4(p.x))); }\n");
  EXPECT_THAT(check(), HasSubstr("render/bad.glsl:2:"));
}

TEST_F(ShaderCheckTest, AsksForTheTargetsOfAScreenPass) {
  folder_.write("render/pass.glsl", "PassOutput shade(ivec2 pixel) { return PassOutput(vec4(1.0)); }\n");
  EXPECT_THAT(failure_of([&] { check(); }), HasSubstr("render/pass.glsl:1: a screen pass must open with its targets"));
  folder_.write("render/pass.glsl", "// targets: rgb9\nPassOutput shade(ivec2 p) { return PassOutput(vec4(1.0)); }\n");
  EXPECT_THAT(failure_of([&] { check(); }), HasSubstr("'rgb9'"));
}

TEST_F(ShaderCheckTest, AValidatorThatCannotRunIsAFailure) {
  folder_.write("render/pass.glsl", "// targets: r32f\nPassOutput shade(ivec2 p) { return PassOutput(vec4(1.0)); }\n");
  EXPECT_NE(check_shaders(ShaderLibrary(folder_.path()), "/no/such/validator", output_.path()), "");
}

}  // namespace
}  // namespace cloudscape::gpu
