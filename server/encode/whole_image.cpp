#include "encode/whole_image.h"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <fstream>
#include <string>
#include <vector>

namespace cloudscape::encode {
namespace {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n", jpeg_end = "\xff\xd9";
constexpr std::string_view png_end("\0\0\0\0IEND\xae\x42\x60\x82", 12);

// `size` bytes at `offset` from the beginning, or from the end where it is negative; fewer where the file is shorter.
std::string bytes_at(std::ifstream& in, std::streamoff offset, std::size_t size) {
  std::string bytes(size, '\0');
  in.clear();
  in.seekg(offset, offset < 0 ? std::ios::end : std::ios::beg);
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, in.gcount())));
  return bytes;
}

int big_endian(std::string_view bytes) {
  int value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

bool ends_with(std::ifstream& in, std::string_view end) {
  return bytes_at(in, -static_cast<std::streamoff>(end.size()), end.size()) == end;
}

bool is_whole_png(std::ifstream& in, const ImageSize& size_px) {
  const std::string head = bytes_at(in, 0, 24);
  return head.size() == 24 && head.starts_with(png_signature) && head.substr(12, 4) == "IHDR" &&
         big_endian(head.substr(16, 4)) == size_px.width && big_endian(head.substr(20, 4)) == size_px.height &&
         ends_with(in, png_end);
}

// The frame header is SOF0 to SOF15 without DHT (C4), JPG (C8) and DAC (CC); segments before it are passed over.
bool is_whole_jpeg(std::ifstream& in, const ImageSize& size_px) {
  if (bytes_at(in, 0, 2) != "\xff\xd8") return false;
  for (std::streamoff offset = 2;;) {
    const std::string segment = bytes_at(in, offset, 9);
    if (segment.size() < 9 || segment[0] != '\xff') return false;
    const int marker = static_cast<unsigned char>(segment[1]);
    if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc)
      return big_endian(segment.substr(5, 2)) == size_px.height && big_endian(segment.substr(7, 2)) == size_px.width &&
             ends_with(in, jpeg_end);
    offset += 2 + big_endian(segment.substr(2, 2));
  }
}

bool is_whole_exr(const std::filesystem::path& path, const ImageSize& size_px) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  if (!file.isComplete() || window.max.x - window.min.x + 1 != size_px.width ||
      window.max.y - window.min.y + 1 != size_px.height)
    return false;
  std::vector<float> line(static_cast<std::size_t>(size_px.width));
  Imf::FrameBuffer buffer;
  buffer.insert("Z", {Imf::FLOAT, reinterpret_cast<char*>(line.data() - window.min.x), sizeof(float), 0});
  file.setFrameBuffer(buffer);
  file.readPixels(window.max.y);  // throws where the last block is cut off
  return true;
}

}  // namespace

bool is_whole_image(const std::filesystem::path& path, ImageFormat format, const ImageSize& size_px) try {
  if (!std::filesystem::is_regular_file(path)) return false;
  if (format == ImageFormat::exr) return is_whole_exr(path, size_px);
  std::ifstream in(path, std::ios::binary);
  return in && (format == ImageFormat::png ? is_whole_png(in, size_px) : is_whole_jpeg(in, size_px));
} catch (const std::exception&) {
  return false;
}

}  // namespace cloudscape::encode
