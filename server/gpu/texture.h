// Textures with immutable storage, and uniform blocks. Move-only; an empty (moved-from, default) object holds nothing.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cloudscape::gpu {

enum class Format { rgba8, r8, r16f, rg16f, rgba16f, rgba32f, r32f, rg32f };
int bytes_per_texel(Format format);
const char* name_of(Format format);           // as GLSL has it: "rgba16f"
Format format_from(const std::string& name);  // throws InvalidInput
enum class Filter { nearest, linear };
enum class Wrap { repeat, clamp };

class Texture {
 public:
  Texture() = default;
  // 2D. `levels`: of a mip chain, each half the size of the one before.
  Texture(Format format, int width, int height, const std::string& label, int levels = 1);
  Texture(Format format, int width, int height, int depth, const std::string& label);  // 3D
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;

  void sample_with(Filter filter, Wrap wrap);  // default: nearest, clamp; linear: between levels as well
  void sample_with(Filter filter, Wrap across, Wrap other_axes);
  void sample_with(Filter filter, Wrap x, Wrap y, Wrap z);
  void upload(std::span<const std::uint8_t> texels);  // all texels, tightly packed, in the texture's own format
  void upload_level(int level, std::span<const std::uint8_t> texels);  // of a 2D texture
  void make_levels();                                                  // from the first, each the mean of four texels
  std::vector<std::uint8_t> download() const;                          // the first level; waits for the device
  void clear();                                                        // to zero
  explicit operator bool() const { return id_ != 0; }
  unsigned id() const { return id_; }
  Format format() const { return format_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int depth() const { return depth_; }
  int levels() const { return levels_; }
  std::size_t bytes() const;  // of the first level

 private:
  unsigned id_ = 0;
  Format format_ = Format::rgba8;
  int width_ = 0, height_ = 0, depth_ = 1, levels_ = 1;
  bool volume_ = false;  // 3D, even if one texel deep
};

// A uniform buffer; `Block` is a struct of shaders/shared, declared by DECLARE_BLOCK.
class UniformBuffer {
 public:
  UniformBuffer() = default;
  UniformBuffer(std::size_t bytes, const std::string& label);
  ~UniformBuffer();
  UniformBuffer(UniformBuffer&& other) noexcept;
  UniformBuffer& operator=(UniformBuffer&& other) noexcept;
  void upload(std::span<const std::byte> bytes);
  void bind(int binding) const;

 private:
  unsigned id_ = 0;
  std::size_t bytes_ = 0;
};

template <class Block>
class UniformBlock {
 public:
  explicit UniformBlock(const std::string& label) : buffer_(sizeof(Block), label) {}
  void upload(const Block& block) { buffer_.upload(std::as_bytes(std::span(&block, 1))); }
  void bind() const { buffer_.bind(Block::binding); }

 private:
  UniformBuffer buffer_;
};

}  // namespace cloudscape::gpu
