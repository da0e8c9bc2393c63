// The context: its state that never changes (pixel alignment, vertex array), and the debug callback.
#include "gpu/context.h"

#include "core/error.h"
#include "core/log.h"
#include "gpu/device_choice.h"
#include "gpu/gl.h"

namespace cloudscape::gpu {

struct Context::State {
  OpenDevice open;
  PassExecution execution;
  GLuint vertex_array = 0;
  int errors = 0;
};

namespace {

// Compile errors are thrown where they happen, with the file and line, so the driver's own message repeats them.
void APIENTRY on_message(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                         const void* errors) {
  const std::string_view message(text, static_cast<std::size_t>(length));
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER || type == GL_DEBUG_TYPE_PERFORMANCE || type == GL_DEBUG_TYPE_OTHER) {
    log::debug("OpenGL: {}", message);
  } else if (type == GL_DEBUG_TYPE_ERROR) {
    ++*static_cast<int*>(const_cast<void*>(errors));
    log::error("OpenGL: {}", message);
  } else {
    log::warn("OpenGL: {}", message);
  }
}

void install_debug_callback(int& errors) {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // in the call that caused it, on this thread
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
  glDebugMessageCallback(on_message, &errors);
}

PassExecution resolved(PassExecution wanted, const DeviceInfo& device) {
  if (wanted != PassExecution::automatic) return wanted;
  return device.software ? PassExecution::fragment : PassExecution::compute;
}

void log_choice(const DeviceInfo& device, PassExecution execution) {
  log::info("rendering on {} ({}, OpenGL {}), EGL device {}{}{}, screen passes as {} shaders", device.renderer,
            device.software ? "software" : "GPU", device.gl_version, device.index, device.drm_file.empty() ? "" : " ",
            device.drm_file, execution == PassExecution::compute ? "compute" : "fragment");
}

}  // namespace

PassExecution pass_execution_from(const std::string& name) {
  if (name == "auto") return PassExecution::automatic;
  if (name == "compute") return PassExecution::compute;
  if (name == "fragment") return PassExecution::fragment;
  throw InvalidInput("--pass-execution", "is '" + name + "': must be auto, compute or fragment");
}

Context::Context(const ContextOptions& options) : state_(std::make_unique<State>()) {
  state_->open = open_device(options);
  state_->execution = resolved(options.execution, device());
  install_debug_callback(state_->errors);
  glCreateVertexArrays(1, &state_->vertex_array);
  glBindVertexArray(state_->vertex_array);  // core profile draws with none bound are errors, even without attributes
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glDisable(GL_DITHER);  // on by default; passes dither for themselves
  log_choice(device(), execution());
}

Context::~Context() {
  glDebugMessageCallback(nullptr, nullptr);
  glDeleteVertexArrays(1, &state_->vertex_array);
}

const DeviceInfo& Context::device() const { return state_->open.info; }
PassExecution Context::execution() const { return state_->execution; }
int Context::gl_errors() const { return state_->errors; }
void Context::flush() const { glFlush(); }
void Context::finish() const { glFinish(); }

}  // namespace cloudscape::gpu
