// Motion JPEG in AVI 1.0, as Microsoft's "AVI RIFF File Reference" lays it out:
//   RIFF 'AVI ' { LIST 'hdrl' { avih, LIST 'strl' { strh, strf } }, LIST 'movi' { 00dc... }, idx1 }
// All numbers are little-endian; chunks begin at even offsets.
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "encode/containers.h"

namespace cloudscape::encode {
namespace {

constexpr std::uint64_t index_entry_bytes = 16, chunk_head_bytes = 8;
constexpr std::uint32_t has_index = 0x10, is_key_frame = 0x10;  // AVIF_HASINDEX, AVIIF_KEYFRAME
constexpr std::uint32_t rate_scale = 1000;  // of frames a second: 29.97 is exact, 30000/1001 to 1e-6

// A part of the file that is built in memory.
class Chunks {
 public:
  Chunks& name(std::string_view four) {
    bytes_.append(four);
    return *this;
  }
  Chunks& u32(std::uint64_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes_ += static_cast<char>(value >> shift);
    return *this;
  }
  Chunks& u16(unsigned value) {
    bytes_ += static_cast<char>(value), bytes_ += static_cast<char>(value >> 8);
    return *this;
  }
  Chunks& zeros(int count_u32) {
    bytes_.append(4 * static_cast<std::size_t>(count_u32), '\0');
    return *this;
  }
  Chunks& nested(std::string_view id, const Chunks& content) {
    name(id).u32(content.bytes_.size());
    bytes_ += content.bytes_;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

struct Totals {
  std::uint64_t frames = 0, largest_frame = 0, file_bytes = 0, movi_bytes = 0;
};

// Everything before the first frame; its size does not depend on the totals.
std::string head(const ContainerLayout& layout, const Totals& totals) {
  const auto width = static_cast<std::uint64_t>(layout.size_px.width), height = std::uint64_t(layout.size_px.height);
  const auto rate = static_cast<std::uint64_t>(std::llround(layout.frames_per_second * rate_scale));
  Chunks main, stream, format, strl, hdrl, riff;
  main.u32(std::uint64_t(std::llround(1e6 / layout.frames_per_second))).u32(0).u32(0).u32(has_index);
  main.u32(totals.frames).u32(0).u32(1).u32(totals.largest_frame).u32(width).u32(height).zeros(4);
  stream.name("vids").name("MJPG").zeros(3).u32(rate_scale).u32(rate).u32(0).u32(totals.frames);
  stream.u32(totals.largest_frame).u32(0xFFFFFFFF).u32(0);  // quality: the driver's default
  stream.u16(0).u16(0).u16(unsigned(layout.size_px.width)).u16(unsigned(layout.size_px.height));
  format.u32(40).u32(width).u32(height).u16(1).u16(24).name("MJPG").u32(width * height * 3).zeros(4);
  strl.name("strl").nested("strh", stream).nested("strf", format);
  hdrl.name("hdrl").nested("avih", main).nested("LIST", strl);
  riff.name("RIFF").u32(totals.file_bytes - chunk_head_bytes).name("AVI ").nested("LIST", hdrl);
  return riff.name("LIST").u32(totals.movi_bytes).name("movi").bytes();
}

class Avi : public FrameContainer {
 public:
  Avi(const std::filesystem::path& path, const ContainerLayout& layout, std::uint64_t max_bytes)
      : path_(path), layout_(layout), max_bytes_(max_bytes) {
    if (layout.format != ImageFormat::jpeg) throw Error("An AVI holds JPEG frames: ask for format jpeg, or for a ZIP.");
    out_.open(path, std::ios::binary | std::ios::trunc);
    write(head(layout_, totals_));
    totals_.movi_bytes = 4;  // "movi" itself
  }
  ~Avi() override {
    if (finished_) return;
    out_.close();
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  void add(const EncodedFrame& image) override {
    const std::uint64_t bytes = image.bytes.size() - image.front, padding = bytes % 2;
    const std::uint64_t index_bytes = (totals_.frames + 1) * index_entry_bytes + chunk_head_bytes;
    if (head_bytes_ + totals_.movi_bytes + chunk_head_bytes + bytes + padding + index_bytes > max_bytes_)
      throw Error("An AVI holds less than 2 GiB: ask for fewer, smaller or more strongly compressed frames, or a ZIP.");
    Chunks head;
    head.name("00dc").u32(bytes);
    write(head.bytes());
    write({reinterpret_cast<const char*>(image.bytes.data()) + image.front, bytes});
    if (padding) write(std::string_view("\0", 1));
    index_.name("00dc").u32(is_key_frame).u32(totals_.movi_bytes).u32(bytes);  // offset from the word "movi"
    totals_.movi_bytes += chunk_head_bytes + bytes + padding;
    totals_.largest_frame = std::max(totals_.largest_frame, bytes);
    ++totals_.frames;
  }

  void finish() override {
    Chunks index;
    write(index.nested("idx1", index_).bytes());
    totals_.file_bytes = static_cast<std::uint64_t>(out_.tellp());
    out_.seekp(0);
    write(head(layout_, totals_));
    out_.close();
    if (!out_) fail();
    finished_ = true;
  }

 private:
  void write(std::string_view bytes) {
    if (!out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) fail();
  }
  [[noreturn]] void fail() const { throw Error("cannot write " + path_.filename().string() + ": is the disk full?"); }

  std::filesystem::path path_;
  ContainerLayout layout_;
  std::uint64_t max_bytes_;
  std::ofstream out_;
  Totals totals_;
  std::uint64_t head_bytes_ = head(layout_, totals_).size();
  Chunks index_;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<FrameContainer> open_avi(const std::filesystem::path& path, const ContainerLayout& layout,
                                         std::uint64_t max_bytes) {
  return std::make_unique<Avi>(path, layout, max_bytes);
}

}  // namespace cloudscape::encode
