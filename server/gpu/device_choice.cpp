// Opens devices in turn until one fits, and words the refusal where none does.
#include "gpu/device_choice.h"

#include <algorithm>
#include <charconv>
#include <iomanip>
#include <sstream>

#include "core/error.h"
#include "gpu/gl.h"

namespace cloudscape::gpu {
namespace {

std::string gl_string(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "";
}

bool is_software_renderer(const std::string& renderer) {
  return std::ranges::any_of(std::initializer_list<const char*>{"llvmpipe", "softpipe", "swrast", "SWR"},
                             [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

// Current on this thread if it is usable.
OpenDevice try_open(const EglDevice& device) {
  OpenDevice open;
  open.info.index = device.index;
  if (!device.drm_files.empty()) open.info.drm_file = device.drm_files.front();
  open.info.software = device.says_software;
  try {
    open.context = std::make_unique<EglContext>(device);
    open.context->make_current();
    open.info.vendor = gl_string(GL_VENDOR);
    open.info.renderer = gl_string(GL_RENDERER);
    open.info.gl_version = gl_string(GL_VERSION);
    open.info.software = is_software_renderer(open.info.renderer);
    open.info.usable = true;
  } catch (const Error& error) {
    open.context.reset();
    open.info.problem = error.what();
  }
  return open;
}

std::string brief(const DeviceInfo& device) {
  const std::string file = device.drm_file.empty() ? "" : " " + device.drm_file;
  const std::string number = "'" + std::to_string(device.index) + "'" + file;
  if (!device.usable) return number + " not usable, " + device.problem;
  return number + " " + device.renderer + (device.software ? ", software" : "");
}

std::string choices(const std::vector<DeviceInfo>& devices) {
  if (devices.empty()) return "EGL lists no device (libegl-mesa0 brings a software one)";
  std::string text = "the devices are ";
  for (const DeviceInfo& device : devices) text += (&device == &devices.front() ? "" : "; ") + brief(device);
  return text;
}

std::vector<EglDevice> matching(const std::vector<EglDevice>& devices, const std::string& name) {
  std::vector<EglDevice> matches;
  if (name == "auto" || name == "software") {
    matches = devices;
    const bool software_last = name == "auto";
    std::ranges::stable_sort(matches, {}, [&](const EglDevice& d) { return d.says_software == software_last; });
    return matches;
  }
  int index = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  const bool is_index = error == std::errc() && end == name.data() + name.size();
  for (const EglDevice& device : devices) {
    const bool has_file = std::ranges::find(device.drm_files, name) != device.drm_files.end();
    if (is_index ? device.index == index : has_file) matches.push_back(device);
  }
  return matches;
}

bool fits(const DeviceInfo& device, const ContextOptions& options) {
  if (options.require_gpu && device.software) return false;
  return options.device != "software" || device.software;
}

// The first that fits; for `auto` a GPU before any software device.
OpenDevice first_fitting(const std::vector<EglDevice>& candidates, const ContextOptions& options) {
  OpenDevice software;
  for (const EglDevice& candidate : candidates) {
    OpenDevice open = try_open(candidate);
    if (!open.context || !fits(open.info, options)) continue;
    if (!open.info.software || options.device != "auto") return open;
    if (!software.context) software = std::move(open);
  }
  return software;
}

[[noreturn]] void refuse(const ContextOptions& options, bool any_match) {
  const std::string listed = choices(enumerate_devices());
  if (!any_match)
    throw InvalidInput("--egl-device",
                       "is '" + options.device +
                           "': must be auto, software, an index or the /dev/dri path of a device, and " + listed);
  if (options.require_gpu)
    throw Error("a GPU is required (--require-gpu), but device '" + options.device + "' gives none: " + listed);
  throw Error("the EGL device '" + options.device + "' cannot be used: " + listed);
}

}  // namespace

std::vector<DeviceInfo> enumerate_devices() {
  const CurrentContextGuard guard;
  std::vector<DeviceInfo> infos;
  for (const EglDevice& device : list_egl_devices()) infos.push_back(try_open(device).info);
  return infos;
}

OpenDevice open_device(const ContextOptions& options) {
  OpenDevice open;
  {
    const CurrentContextGuard guard;  // a refusal leaves the thread as it was
    const std::vector<EglDevice> candidates = matching(list_egl_devices(), options.device);
    open = first_fitting(candidates, options);
    if (!open.context) refuse(options, !candidates.empty() || options.device == "auto" || options.device == "software");
  }
  open.context->make_current();
  return open;
}

std::string describe(const std::vector<DeviceInfo>& devices) {
  std::ostringstream table;
  table << std::left << std::setw(7) << "index" << std::setw(8) << "usable" << std::setw(10) << "kind" << std::setw(22)
        << "file"
        << "renderer, OpenGL, or why not\n";
  for (const DeviceInfo& device : devices) {
    table << std::setw(7) << device.index << std::setw(8) << (device.usable ? "yes" : "no") << std::setw(10)
          << (device.software ? "software" : "GPU") << std::setw(22)
          << (device.drm_file.empty() ? "-" : device.drm_file)
          << (device.usable ? device.renderer + ", OpenGL " + device.gl_version : device.problem) << "\n";
  }
  return table.str();
}

}  // namespace cloudscape::gpu
