// Height maps for tests: written as PNG or EXR into a folder that is removed at the end.
#pragma once
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <png.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cloudscape {

class HeightMapFolder {
 public:
  HeightMapFolder() { std::filesystem::create_directories(path_); }
  ~HeightMapFolder() { std::filesystem::remove_all(path_); }
  HeightMapFolder(const HeightMapFolder&) = delete;
  HeightMapFolder& operator=(const HeightMapFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // `format`: PNG_FORMAT_GRAY with bytes, PNG_FORMAT_LINEAR_Y with words, ...; top row first.
  template <class T>
  void write_png(const std::string& name, int width, int height, const std::vector<T>& pixels, unsigned format) const {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width), image.height = static_cast<png_uint_32>(height);
    image.format = format;
    png_image_write_to_file(&image, (path_ / name).c_str(), 0, pixels.data(), 0, nullptr);
  }
  // All `channels` alike.
  void write_exr(const std::string& name, int width, int height, const std::vector<float>& pixels,
                 const std::vector<std::string>& channels = {"Y"}) const {
    Imf::Header header(width, height);
    Imf::FrameBuffer buffer;
    for (const std::string& channel : channels) {
      header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
      char* base = reinterpret_cast<char*>(const_cast<float*>(pixels.data()));
      buffer.insert(channel,
                    Imf::Slice(Imf::FLOAT, base, sizeof(float), sizeof(float) * static_cast<std::size_t>(width)));
    }
    Imf::OutputFile file((path_ / name).c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
  }

 private:
  static inline int count_ = 0;
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("cloudscape-height-maps-" + std::to_string(getpid()) + "-" + std::to_string(count_++));
};

}  // namespace cloudscape
