// EGL without a display: which devices there are, and the one OpenGL 4.5 core context of the render thread.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace cloudscape::gpu {

struct DeviceInfo {
  int index = 0;         // as EGL lists it
  std::string drm_file;  // /dev/dri/renderD128 or /dev/dri/card0; "" where it has none
  std::string vendor, renderer, gl_version;
  bool software = false;  // llvmpipe, softpipe, swrast
  bool usable = false;
  std::string problem;  // why it is not usable, with the EGL error
};

// Every EGL device, tried out: initialized, a context made, the renderer asked. Throws Error where EGL itself is
// missing.
std::vector<DeviceInfo> enumerate_devices();

// A table for people, one line a device.
std::string describe(const std::vector<DeviceInfo>& devices);

// compute: heavy passes as compute dispatches. fragment: as full-screen triangles. automatic: fragment on a software
// rasterizer (1.5 times faster there, measured), compute on a GPU (data-centre GPUs have few units for fragment
// shaders).
enum class PassExecution { automatic, compute, fragment };
PassExecution pass_execution_from(const std::string& name);  // auto, compute, fragment; throws InvalidInput

struct ContextOptions {
  std::string device =
      "auto";  // auto (the first GPU that works, else software), software, an index, or a /dev/dri/... path
  bool require_gpu = false;
  PassExecution execution = PassExecution::automatic;
};

// Current on the thread that makes it, from birth to death; every other object of this folder belongs to it. The debug
// callback is installed: errors are logged as errors, and counted.
class Context {
 public:
  explicit Context(
      const ContextOptions& options);  // throws Error / InvalidInput: one sentence, with the devices that there are
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const DeviceInfo& device() const;
  PassExecution execution() const;  // compute or fragment
  int gl_errors() const;            // that the debug callback has seen
  void flush() const;
  void finish() const;  // waits until the device is idle

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cloudscape::gpu
