// Compiles and links, with the driver's log explained; asks the driver how it laid a block out.
#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"
#include "gpu/gl.h"
#include "gpu/pass.h"
#include "gpu/pass_wrapper.h"

namespace cloudscape::gpu {
namespace {

template <class GetParameter, class GetLog>
std::string log_of(GLuint id, GetParameter get_parameter, GetLog get_log) {
  GLint size = 0;
  get_parameter(id, GL_INFO_LOG_LENGTH, &size);
  std::string log(static_cast<std::size_t>(std::max(size, 1)), '\0');
  get_log(id, size, &size, log.data());
  log.resize(static_cast<std::size_t>(std::max(size, 0)));
  while (!log.empty() && (log.back() == '\n' || log.back() == ' ')) log.pop_back();
  return log;
}

// Deletes itself; a linked program keeps what it needs of it.
class Stage {
 public:
  Stage(GLenum kind, const ShaderSource& source, const std::string& label) : id_(glCreateShader(kind)) {
    label_object(GL_SHADER, id_, label);
    const char* text = source.text.c_str();
    glShaderSource(id_, 1, &text, nullptr);
    glCompileShader(id_);
    GLint compiled = GL_FALSE;
    glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    const std::string log = source.explain(log_of(id_, glGetShaderiv, glGetShaderInfoLog));
    glDeleteShader(id_);
    throw Error("the shader '" + label + "' does not compile:\n" + log);
  }
  ~Stage() { glDeleteShader(id_); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  GLuint id() const { return id_; }

 private:
  GLuint id_;
};

void link(GLuint program, std::initializer_list<GLuint> stages, const ShaderSource& source, const std::string& label) {
  label_object(GL_PROGRAM, program, label);
  for (const GLuint stage : stages) glAttachShader(program, stage);
  glLinkProgram(program);
  for (const GLuint stage : stages) glDetachShader(program, stage);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  throw Error("the shader '" + label + "' does not link:\n" +
              source.explain(log_of(program, glGetProgramiv, glGetProgramInfoLog)));
}

std::string resource_name(GLuint program, GLuint index) {
  std::array<char, 256> name{};
  GLsizei size = 0;
  glGetProgramResourceName(program, GL_UNIFORM, index, static_cast<GLsizei>(name.size()), &size, name.data());
  return {name.data(), static_cast<std::size_t>(size)};
}

std::vector<GLint> block_variables(GLuint program, GLuint block) {
  GLint count = 0;
  constexpr GLenum number = GL_NUM_ACTIVE_VARIABLES, list = GL_ACTIVE_VARIABLES;
  glGetProgramResourceiv(program, GL_UNIFORM_BLOCK, block, 1, &number, 1, nullptr, &count);
  std::vector<GLint> variables(static_cast<std::size_t>(count));
  glGetProgramResourceiv(program, GL_UNIFORM_BLOCK, block, 1, &list, count, nullptr, variables.data());
  return variables;
}

}  // namespace

Program Program::compute(const ShaderSource& source, const std::string& label) {
  const Stage stage(GL_COMPUTE_SHADER, source, label);
  Program program;
  program.id_ = glCreateProgram();
  link(program.id_, {stage.id()}, source, label);
  return program;
}

Program Program::fragment(const ShaderSource& source, const std::string& label, bool tiles) {
  const Stage triangle(GL_VERTEX_SHADER, {tiles ? tiles_shader() : triangle_shader(), {}}, "full-screen triangle");
  const Stage stage(GL_FRAGMENT_SHADER, source, label);
  Program program;
  program.id_ = glCreateProgram();
  link(program.id_, {triangle.id(), stage.id()}, source, label);
  return program;
}

Program::~Program() { glDeleteProgram(id_); }

Program::Program(Program&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

std::vector<std::pair<std::string, int>> Program::block_offsets(const std::string& block) const {
  const GLuint index = glGetProgramResourceIndex(id_, GL_UNIFORM_BLOCK, block.c_str());
  if (index == GL_INVALID_INDEX) throw NotFound("the program has no uniform block '" + block + "'");
  std::vector<std::pair<std::string, int>> offsets;
  for (const GLint variable : block_variables(id_, index)) {
    constexpr GLenum what = GL_OFFSET;
    GLint offset = 0;
    glGetProgramResourceiv(id_, GL_UNIFORM, static_cast<GLuint>(variable), 1, &what, 1, nullptr, &offset);
    const std::string name = resource_name(id_, static_cast<GLuint>(variable));
    offsets.emplace_back(name.substr(name.rfind('.') + 1),
                         offset);  // "FrameBlock.size_px", or without an instance bare
  }
  std::ranges::sort(offsets, {}, &std::pair<std::string, int>::second);
  return offsets;
}

}  // namespace cloudscape::gpu
