#include "gpu/storage.h"

#include <utility>

#include "core/error.h"
#include "core/log.h"
#include "gpu/format.h"

namespace cloudscape::gpu {

StorageBuffer::StorageBuffer(std::size_t bytes, const std::string& label) : bytes_(bytes) {
  GLint64 limit = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
  if (bytes == 0 || bytes > static_cast<std::size_t>(limit))
    throw Error("the device has no storage of " + std::to_string(bytes) + " bytes for '" + label + "': 1 to " +
                std::to_string(limit) + " are possible");
  glCreateBuffers(1, &id_);
  label_object(GL_BUFFER, id_, label);
  glNamedBufferStorage(id_, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
  glClearNamedBufferData(id_, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

StorageBuffer::~StorageBuffer() { glDeleteBuffers(1, &id_); }

StorageBuffer::StorageBuffer(StorageBuffer&& other) noexcept { *this = std::move(other); }

StorageBuffer& StorageBuffer::operator=(StorageBuffer&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

void StorageBuffer::upload(std::span<const std::byte> bytes) {
  if (bytes.size() > bytes_)
    throw Error("a storage buffer of " + std::to_string(bytes_) + " bytes cannot take " + std::to_string(bytes.size()));
  glNamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void StorageBuffer::download(std::span<std::byte> bytes) const {
  if (bytes.size() > bytes_)
    throw Error("a storage buffer of " + std::to_string(bytes_) + " bytes has no " + std::to_string(bytes.size()));
  glGetNamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void StorageBuffer::bind(int binding) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), id_);
}

StoragePass::StoragePass(ShaderLibrary& shaders, const std::string& path)
    : path_(path), program_(Program::compute(shaders.load(path), path)) {}

void StoragePass::run(int invocations, std::span<const Binding> textures,
                      std::span<const Texture* const> images) const {
  glUseProgram(program_.id());
  for (const Binding& binding : textures) glBindTextureUnit(static_cast<GLuint>(binding.unit), binding.texture->id());
  for (std::size_t i = 0; i < images.size(); ++i)
    glBindImageTexture(static_cast<GLuint>(i), images[i]->id(), 0, GL_TRUE, 0, GL_READ_WRITE,
                       row_of(images[i]->format()).internal);
  glDispatchCompute(static_cast<GLuint>((invocations + group - 1) / group), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void StoragePass::reload(ShaderLibrary& shaders) {
  try {
    program_ = Program::compute(shaders.load(path_), path_);
    log::info("reloaded the shader {}", path_);
  } catch (const Error& error) {
    log::error("{} (the one before stays in use)", error.what());
  }
}

}  // namespace cloudscape::gpu
