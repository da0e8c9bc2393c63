// What we read back from our own EXRs.
#include "encode/exr_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "frames.h"

namespace cloudscape {
namespace {

namespace fs = std::filesystem;

fs::path written(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  const fs::path path = fs::path(testing::TempDir()) / ("exr-reader-" + name + ".exr");
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  return path;
}

Frame traced_frame() {
  Frame frame;
  frame.request.size_px = {5, 3};
  frame.request.cloudscape = std::make_shared<Cloudscape>();
  for (int i = 0; i < 5 * 3; ++i) {
    for (int c = 0; c < 4; ++c) frame.radiance_rgba.push_back(0.1F * static_cast<float>(4 * i + c));
    for (int c = 0; c < 3; ++c) frame.standard_error_rgb.push_back(1e-6F * static_cast<float>(3 * i + c));
    frame.depth_m.push_back(1000);
  }
  return frame;
}

std::vector<std::uint8_t> bytes_of(const Frame& frame) {
  Encoding encoding;
  encoding.format = ImageFormat::exr;
  encoding.exr_type = ExrType::float32;
  return encode::encode(frame, encoding).bytes;
}

std::string failure(const fs::path& path, const ImageSize& size_px) {
  try {
    encode::read_exr(path, size_px);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ExrReader, ReadsWhatWasWritten) {
  const Frame frame = traced_frame();
  const Frame read = encode::read_exr(written("whole", bytes_of(frame)), {5, 3});
  EXPECT_EQ(read.radiance_rgba, frame.radiance_rgba);
  EXPECT_EQ(read.standard_error_rgb, frame.standard_error_rgb);
  EXPECT_EQ(read.request.size_px, frame.request.size_px);
}

TEST(ExrReader, DoesWithoutStandardErrors) {
  Frame frame = traced_frame();
  frame.standard_error_rgb.clear();
  EXPECT_TRUE(encode::read_exr(written("marched", bytes_of(frame)), {5, 3}).standard_error_rgb.empty());
}

TEST(ExrReader, TellsWhatCannotBeRead) {
  const auto bytes = bytes_of(traced_frame());
  EXPECT_NE(failure(written("size", bytes), {5, 4}).find("not of the size"), std::string::npos);
  const fs::path cut = written("cut", {bytes.begin(), bytes.end() - 40});
  EXPECT_NE(failure(cut, {5, 3}).find(cut.string()), std::string::npos);
  EXPECT_NE(failure("/nowhere/at/all.exr", {5, 3}).find("remove it"), std::string::npos);
}

}  // namespace
}  // namespace cloudscape
