// The EGL calls: the devices of the machine, and one surfaceless OpenGL context on one of them.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gpu/context.h"

namespace cloudscape::gpu {

struct EglDevice {
  void* handle = nullptr;              // EGLDeviceEXT
  int index = 0;                       // as EGL lists it
  std::vector<std::string> drm_files;  // the render node first; often none
  bool says_software = false;          // EGL_MESA_device_software; only the renderer's name is certain
};

// In EGL's order. Throws Error where EGL cannot list devices.
std::vector<EglDevice> list_egl_devices();

// Open from birth to death, and current on this thread after make_current().
class EglContext {
 public:
  explicit EglContext(const EglDevice& device);  // throws Error: the step that failed and EGL's reason
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  void make_current() const;

 private:
  std::shared_ptr<void> display_;  // EGLDisplay, terminated when its last context is gone
  void* context_ = nullptr;
};

// Puts back, at its end, the context that was current at its start.
class CurrentContextGuard {
 public:
  CurrentContextGuard();
  ~CurrentContextGuard();
  CurrentContextGuard(const CurrentContextGuard&) = delete;
  CurrentContextGuard& operator=(const CurrentContextGuard&) = delete;

 private:
  void *display_, *context_;
};

}  // namespace cloudscape::gpu
