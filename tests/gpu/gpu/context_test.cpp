// Which device is chosen, and what a user reads when none fits.
#include "gpu/context.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "core/error.h"
#include "fixture.h"
#include "gpu/texture.h"

namespace cloudscape::gpu {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ContextTest : public GpuTest {};

std::string refusal(const std::string& device, bool require_gpu = false) {
  try {
    const Context context({device, require_gpu, PassExecution::automatic});
    return "made a context";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST_F(ContextTest, ListsADeviceThatWorks) {
  const auto devices = enumerate_devices();
  const auto usable = std::ranges::find_if(devices, &DeviceInfo::usable);
  ASSERT_NE(usable, devices.end());
  EXPECT_FALSE(usable->renderer.empty());
  EXPECT_THAT(usable->gl_version, HasSubstr("4."));
  for (const DeviceInfo& device : devices) EXPECT_EQ(device.usable, device.problem.empty()) << device.index;
}

TEST_F(ContextTest, ListingDevicesLeavesTheContextWorking) {
  Texture texture(Format::r8, 2, 2, "before");
  texture.upload(std::vector<std::uint8_t>{1, 2, 3, 4});
  enumerate_devices();
  EXPECT_EQ(texture.download(), (std::vector<std::uint8_t>{1, 2, 3, 4}));
}

TEST_F(ContextTest, AnUnknownDeviceIsOneSentenceWithTheChoices) {
  const std::string name = context().device().renderer;
  for (const char* wrong : {"foo", "", "99", "-1", "0x", "/dev/dri/renderD999"})
    EXPECT_THAT(refusal(wrong),
                AllOf(HasSubstr("--egl-device is '" + std::string(wrong) + "'"),
                      HasSubstr("must be auto, software, an index or"), HasSubstr(name), Not(HasSubstr("\n"))));
  EXPECT_THROW(Context({"foo", false, PassExecution::automatic}), InvalidInput);
}

TEST_F(ContextTest, RequiringAGpuRefusesSoftware) {
  EXPECT_THAT(refusal("software", true), AllOf(HasSubstr("--require-gpu"), HasSubstr("the devices are")));
  const auto devices = enumerate_devices();
  if (std::ranges::any_of(devices, [](const DeviceInfo& d) { return d.usable && !d.software; }))
    GTEST_SKIP() << "there is a GPU here";
  EXPECT_THAT(refusal("auto", true), HasSubstr("--require-gpu"));
  EXPECT_THAT(refusal("0", true), HasSubstr("--require-gpu"));
}

TEST_F(ContextTest, ARefusalLeavesTheContextWorking) {
  Texture texture(Format::r8, 1, 1, "before");
  texture.upload(std::vector<std::uint8_t>{7});
  refusal("software", true);
  EXPECT_EQ(texture.download().front(), 7);
}

TEST_F(ContextTest, AutomaticExecutionFollowsTheDevice) {
  EXPECT_EQ(context().execution(), context().device().software ? PassExecution::fragment : PassExecution::compute);
  EXPECT_EQ(pass_execution_from("compute"), PassExecution::compute);
  EXPECT_EQ(pass_execution_from("auto"), PassExecution::automatic);
  EXPECT_THROW(pass_execution_from("vertex"), InvalidInput);
}

TEST_F(OwnContextTest, AnIndexChoosesThatDeviceAndForcesAnExecution) {
  const auto devices = enumerate_devices();
  const auto usable = std::ranges::find_if(devices, &DeviceInfo::usable);
  ASSERT_NE(usable, devices.end());
  const Context context({std::to_string(usable->index), false, PassExecution::compute});
  EXPECT_EQ(context.device().index, usable->index);
  EXPECT_EQ(context.device().renderer, usable->renderer);
  EXPECT_EQ(context.execution(), PassExecution::compute);
}

TEST_F(OwnContextTest, CountsTheErrorsOfTheDebugCallback) {
  const Context context(ContextOptions{});
  const UniformBuffer buffer(16, "buffer");
  buffer.bind(3);
  EXPECT_EQ(context.gl_errors(), 0);
  buffer.bind(1 << 20);  // far above GL_MAX_UNIFORM_BUFFER_BINDINGS
  EXPECT_EQ(context.gl_errors(), 1);
}

// In a child process, since EGL reads its environment once.
void expect_refusal_in(const char* variable, const char* value, const char* device, const char* expected) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto refuse_and_exit = [&] {
    setenv(variable, value, 1);
    std::cerr << refusal(device);
    std::exit(0);
  };
  EXPECT_EXIT(refuse_and_exit(), testing::ExitedWithCode(0), expected);
}

TEST(ContextDeathTest, WithoutADriverTheSentenceSaysWhatToInstall) {
  expect_refusal_in("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", "auto", "install libegl1 with libegl-mesa0");
}

TEST(ContextDeathTest, ADeviceThatFailsIsListedWithItsReason) {
  const char* mesa = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";
  if (!std::filesystem::exists(mesa)) GTEST_SKIP() << "Mesa's EGL is not installed";
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", mesa, 1);
  expect_refusal_in("LIBGL_DRIVERS_PATH", "/nonexistent", "auto",
                    "'auto' cannot be used: the devices are '0'.* not usable, eglInitialize failed .EGL_NOT_INIT");
  expect_refusal_in("MESA_GL_VERSION_OVERRIDE", "4.2", "0", "'0' cannot be used: .*OpenGL 4.5 core context failed");
  unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
}

TEST(DescribeDevices, SaysWhichWorkAndWhyTheOthersDoNot) {
  const std::string table = describe({{0, "/dev/dri/renderD128", "NVIDIA", "NVIDIA H200", "4.6.0", false, true, ""},
                                      {1, "", "", "", "", true, false, "eglInitialize failed (EGL_NOT_INITIALIZED)"}});
  EXPECT_THAT(table, testing::ContainsRegex("0 +yes +GPU +/dev/dri/renderD128 +NVIDIA H200, OpenGL 4.6.0\n"));
  EXPECT_THAT(table, testing::ContainsRegex("1 +no +software +- +eglInitialize failed"));
}

}  // namespace
}  // namespace cloudscape::gpu
