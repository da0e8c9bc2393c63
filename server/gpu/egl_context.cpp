// Every EGL call: extensions, devices, displays that are counted, and contexts without a surface.
#include "gpu/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <map>
#include <mutex>
#include <string_view>

#include "core/error.h"

namespace cloudscape::gpu {
namespace {

std::string egl_error() {
  static const std::map<EGLint, const char*> names = {
      {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
      {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
      {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
      {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
      {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
      {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
      {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
      {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
      {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
      {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
      {EGL_BAD_DEVICE_EXT, "EGL_BAD_DEVICE_EXT"},
      {EGL_SUCCESS, "no EGL error"},
  };
  const EGLint code = eglGetError();
  const auto found = names.find(code);
  return found != names.end() ? found->second : "EGL error " + std::to_string(code);
}

[[noreturn]] void fail(const std::string& step) { throw Error(step + " failed (" + egl_error() + ")"); }

// Whole words only: EGL_EXT_device_query is a prefix of EGL_EXT_device_query_name.
bool has_extension(const char* extensions, std::string_view name) {
  if (extensions == nullptr) return false;
  const std::string padded = " " + std::string(extensions) + " ";
  return padded.find(" " + std::string(name) + " ") != std::string::npos;
}

template <class Function>
Function entry_point(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

void require_device_platform() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const bool listing =
      has_extension(extensions, "EGL_EXT_device_base") ||
      (has_extension(extensions, "EGL_EXT_device_enumeration") && has_extension(extensions, "EGL_EXT_device_query"));
  if (!listing || !has_extension(extensions, "EGL_EXT_platform_device"))
    throw Error(
        "EGL here cannot list devices (EGL_EXT_device_enumeration, EGL_EXT_device_query and EGL_EXT_platform_device): "
        "install libegl1 with libegl-mesa0, or NVIDIA's driver with its EGL library");
}

EglDevice describe_device(EGLDeviceEXT handle, int index) {
  const auto query_string = entry_point<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const char* extensions = query_string(handle, EGL_EXTENSIONS);
  EglDevice device{handle, index, {}, has_extension(extensions, "EGL_MESA_device_software")};
  // The render node is what a container is given, the card what people find; not every driver tells them.
  for (const auto& [extension, name] : {std::pair{"EGL_EXT_device_drm_render_node", EGL_DRM_RENDER_NODE_FILE_EXT},
                                        std::pair{"EGL_EXT_device_drm", EGL_DRM_DEVICE_FILE_EXT}}) {
    const char* file = has_extension(extensions, extension) ? query_string(handle, name) : nullptr;
    if (file != nullptr) device.drm_files.emplace_back(file);
  }
  eglGetError();  // a string that a driver does not have is no failure of what comes next
  return device;
}

// EGL hands out one display a device and counts no users, so that terminating it under one context would end all
// others on it (a probe while a renderer runs): the users are counted here.
std::shared_ptr<void> open_display(EGLDeviceEXT device) {
  // Never destroyed, since a context with static storage may outlive every static of this function.
  static std::mutex& mutex = *new std::mutex;
  static auto& open = *new std::map<EGLDisplay, std::weak_ptr<void>>;
  const std::lock_guard lock(mutex);
  const auto get_display = entry_point<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const EGLDisplay display = get_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  if (display == EGL_NO_DISPLAY) fail("eglGetPlatformDisplayEXT");
  if (auto shared = open[display].lock()) return shared;
  if (!eglInitialize(display, nullptr, nullptr)) fail("eglInitialize");
  std::shared_ptr<void> shared(display, [](void* closing) {
    const std::lock_guard closing_lock(mutex);
    if (open[closing].expired()) eglTerminate(closing);
  });
  open[display] = shared;
  return shared;
}

EGLConfig choose_config(EGLDisplay display) {
  if (has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
  constexpr std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) fail("eglChooseConfig for OpenGL");
  return config;
}

EGLContext create_context(EGLDisplay display) {
  if (!has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
    throw Error("the driver has no EGL_KHR_surfaceless_context");
  if (!eglBindAPI(EGL_OPENGL_API)) fail("eglBindAPI for OpenGL");
  constexpr std::array<EGLint, 9> wanted = {EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_CONTEXT_OPENGL_DEBUG,
                                            EGL_TRUE,
                                            EGL_NONE};
  const EGLContext context = eglCreateContext(display, choose_config(display), EGL_NO_CONTEXT, wanted.data());
  if (context == EGL_NO_CONTEXT) fail("making an OpenGL 4.5 core context");
  return context;
}

}  // namespace

std::vector<EglDevice> list_egl_devices() {
  require_device_platform();
  const auto query_devices = entry_point<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (!query_devices(0, nullptr, &count)) fail("eglQueryDevicesEXT");
  std::vector<EGLDeviceEXT> handles(static_cast<std::size_t>(count));
  if (!query_devices(count, handles.data(), &count)) fail("eglQueryDevicesEXT");
  std::vector<EglDevice> devices;
  for (int i = 0; i < count; ++i) devices.push_back(describe_device(handles[static_cast<std::size_t>(i)], i));
  return devices;
}

EglContext::EglContext(const EglDevice& device)
    : display_(open_display(device.handle)), context_(create_context(display_.get())) {}

EglContext::~EglContext() {
  if (eglGetCurrentContext() == context_)
    eglMakeCurrent(display_.get(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_.get(), context_);
}

void EglContext::make_current() const {
  if (!eglMakeCurrent(display_.get(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) fail("eglMakeCurrent");
}

CurrentContextGuard::CurrentContextGuard() : display_(eglGetCurrentDisplay()), context_(eglGetCurrentContext()) {}

CurrentContextGuard::~CurrentContextGuard() {
  if (context_ != EGL_NO_CONTEXT) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

}  // namespace cloudscape::gpu
