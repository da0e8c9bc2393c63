// Storage buffers, and compute passes that keep their state in them from dispatch to dispatch.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "gpu/pass.h"

namespace cloudscape::gpu {

// Memory of the device that shaders read and write: `layout(std430, binding = n) buffer`. Move-only; an empty object
// holds nothing.
class StorageBuffer {
 public:
  StorageBuffer() = default;
  StorageBuffer(std::size_t bytes, const std::string& label);  // zeros. Throws Error if the device has no such block
  ~StorageBuffer();
  StorageBuffer(StorageBuffer&& other) noexcept;
  StorageBuffer& operator=(StorageBuffer&& other) noexcept;
  void upload(std::span<const std::byte> bytes);    // from the beginning
  void download(std::span<std::byte> bytes) const;  // waits for the device
  void bind(int binding) const;
  std::size_t bytes() const { return bytes_; }

 private:
  unsigned id_ = 0;
  std::size_t bytes_ = 0;
};

// A compute shader of one dimension, `layout(local_size_x = 64)`. It keeps what it computes in storage buffers and in
// images that it reads and writes.
class StoragePass {
 public:
  static constexpr int group = 64;
  StoragePass(ShaderLibrary& shaders, const std::string& path);
  // At least `invocations`, in whole groups. Storage buffers and uniform blocks are bound by the caller; `images` are
  // bound to the image units 0, 1, ... Makes what it wrote visible to later passes and to downloads.
  void run(int invocations, std::span<const Binding> textures, std::span<const Texture* const> images) const;
  // Compiles the shader anew; if that fails the old program stays and the error is logged.
  void reload(ShaderLibrary& shaders);
  const Program& program() const { return program_; }

 private:
  std::string path_;
  Program program_;
};

}  // namespace cloudscape::gpu
