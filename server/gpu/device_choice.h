// Which device to render on: tries the devices in turn, and says in one sentence why none will do.
#pragma once
#include <memory>

#include "gpu/egl_context.h"

namespace cloudscape::gpu {

struct OpenDevice {
  DeviceInfo info;
  std::unique_ptr<EglContext> context;  // null where the device is not usable
};

// The device that `options` asks for, current on this thread. Throws Error or InvalidInput.
OpenDevice open_device(const ContextOptions& options);

}  // namespace cloudscape::gpu
