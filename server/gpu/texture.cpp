// Textures and uniform buffers by direct state access.
#include "gpu/texture.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "gpu/format.h"

namespace cloudscape::gpu {
namespace {

void forget_errors() {
  while (glGetError() != GL_NO_ERROR) {
  }
}

std::string size_text(int width, int height, int depth) {
  const std::string plane = std::to_string(width) + "x" + std::to_string(height);
  return depth == 0 ? plane : plane + "x" + std::to_string(depth);
}

// `depth` 0: 2D.
bool fits_the_device(int width, int height, int depth) {
  GLint limit = 0;
  glGetIntegerv(depth == 0 ? GL_MAX_TEXTURE_SIZE : GL_MAX_3D_TEXTURE_SIZE, &limit);
  return width >= 1 && height >= 1 && std::max({width, height, depth}) <= limit;
}

GLuint make_texture(Format format, int width, int height, int depth, int levels, const std::string& label) {
  const Error refusal("the device cannot make the texture '" + label + "' of " + size_text(width, height, depth) +
                      " texels in " + name_of(format) + ": choose another size");
  if (!fits_the_device(width, height, depth)) throw refusal;
  GLuint id = 0;
  forget_errors();
  glCreateTextures(depth == 0 ? GL_TEXTURE_2D : GL_TEXTURE_3D, 1, &id);
  label_object(GL_TEXTURE, id, label);
  if (depth == 0)
    glTextureStorage2D(id, levels, row_of(format).internal, width, height);
  else
    glTextureStorage3D(id, 1, row_of(format).internal, width, height, depth);
  if (glGetError() == GL_NO_ERROR) return id;
  glDeleteTextures(1, &id);
  throw refusal;
}

}  // namespace

Texture::Texture(Format format, int width, int height, const std::string& label, int levels)
    : id_(make_texture(format, width, height, 0, levels, label)),
      format_(format),
      width_(width),
      height_(height),
      levels_(levels) {
  sample_with(Filter::nearest, Wrap::clamp);
}

Texture::Texture(Format format, int width, int height, int depth, const std::string& label)
    : format_(format), width_(width), height_(height), depth_(depth), volume_(true) {
  if (depth < 1) throw Error("the volume '" + label + "' needs a depth of 1 or more, not " + std::to_string(depth));
  id_ = make_texture(format, width, height, depth, 1, label);
  sample_with(Filter::nearest, Wrap::clamp);
}

Texture::~Texture() { glDeleteTextures(1, &id_); }

Texture::Texture(Texture&& other) noexcept { *this = std::move(other); }

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(format_, other.format_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(depth_, other.depth_);
  std::swap(levels_, other.levels_);
  std::swap(volume_, other.volume_);
  return *this;
}

void Texture::sample_with(Filter filter, Wrap wrap) { sample_with(filter, wrap, wrap); }

void Texture::sample_with(Filter filter, Wrap across, Wrap other_axes) {
  sample_with(filter, across, other_axes, other_axes);
}

void Texture::sample_with(Filter filter, Wrap x, Wrap y, Wrap z) {
  const GLint filtering = filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
  const GLint between_levels = filter == Filter::linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
  const auto wrapping = [](Wrap wrap) { return wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; };
  glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, levels_ > 1 ? between_levels : filtering);
  glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, filtering);
  glTextureParameteri(id_, GL_TEXTURE_WRAP_S, wrapping(x));
  glTextureParameteri(id_, GL_TEXTURE_WRAP_T, wrapping(y));
  glTextureParameteri(id_, GL_TEXTURE_WRAP_R, wrapping(z));
}

void Texture::upload(std::span<const std::uint8_t> texels) {
  if (texels.size() != bytes())
    throw Error("a texture of " + std::to_string(bytes()) + " bytes cannot take " + std::to_string(texels.size()));
  const FormatRow& row = row_of(format_);
  if (volume_)
    glTextureSubImage3D(id_, 0, 0, 0, 0, width_, height_, depth_, row.components, row.type, texels.data());
  else
    glTextureSubImage2D(id_, 0, 0, 0, width_, height_, row.components, row.type, texels.data());
}

void Texture::upload_level(int level, std::span<const std::uint8_t> texels) {
  const int width = std::max(1, width_ >> level), height = std::max(1, height_ >> level);
  const std::size_t bytes = std::size_t(width) * std::size_t(height) * std::size_t(bytes_per_texel(format_));
  if (volume_ || level < 0 || level >= levels_ || texels.size() != bytes)
    throw Error("a texture of " + std::to_string(levels_) + " levels cannot take " + std::to_string(texels.size()) +
                " bytes in level " + std::to_string(level));
  const FormatRow& row = row_of(format_);
  glTextureSubImage2D(id_, level, 0, 0, width, height, row.components, row.type, texels.data());
}

void Texture::make_levels() { glGenerateTextureMipmap(id_); }

std::vector<std::uint8_t> Texture::download() const {
  std::vector<std::uint8_t> texels(bytes());
  const FormatRow& row = row_of(format_);
  glGetTextureImage(id_, 0, row.components, row.type, static_cast<GLsizei>(texels.size()), texels.data());
  return texels;
}

void Texture::clear() {
  const FormatRow& row = row_of(format_);
  glClearTexImage(id_, 0, row.components, row.type, nullptr);
}

std::size_t Texture::bytes() const {
  return std::size_t(width_) * std::size_t(height_) * std::size_t(depth_) * std::size_t(bytes_per_texel(format_));
}

UniformBuffer::UniformBuffer(std::size_t bytes, const std::string& label) : bytes_(bytes) {
  glCreateBuffers(1, &id_);
  label_object(GL_BUFFER, id_, label);
  glNamedBufferStorage(id_, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
}

UniformBuffer::~UniformBuffer() { glDeleteBuffers(1, &id_); }

UniformBuffer::UniformBuffer(UniformBuffer&& other) noexcept { *this = std::move(other); }

UniformBuffer& UniformBuffer::operator=(UniformBuffer&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

void UniformBuffer::upload(std::span<const std::byte> bytes) {
  if (bytes.size() > bytes_)
    throw Error("a uniform buffer of " + std::to_string(bytes_) + " bytes cannot take " + std::to_string(bytes.size()));
  glNamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void UniformBuffer::bind(int binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), id_); }

}  // namespace cloudscape::gpu
