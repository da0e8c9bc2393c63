// Sequences as one file: ZIPs as libarchive reads them, AVIs chunk by chunk, and no file where one was not finished.
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "core/error.h"
#include "encode/containers.h"

namespace cloudscape::encode {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Containers : public testing::Test {
 protected:
  fs::path file(const std::string& name = "result") const { return folder_ / name; }
  static EncodedFrame frame(std::string_view bytes, std::size_t front = 0) {
    EncodedFrame image{std::vector<std::uint8_t>(front, 0xEE), front, ImageFormat::jpeg, 0};
    image.bytes.insert(image.bytes.end(), bytes.begin(), bytes.end());
    return image;
  }
  static ContainerLayout layout(ContainerKind kind) { return {kind, ImageFormat::jpeg, {640, 360}, 29.97, 7, 3}; }
  static std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  const fs::path folder_ = fs::temp_directory_path() / ("cloudscape-containers-" + std::to_string(::getpid()));
};

std::vector<std::pair<std::string, std::string>> entries_of(const fs::path& path) {
  std::vector<std::pair<std::string, std::string>> entries;
  archive* in = archive_read_new();
  archive_read_support_format_zip_seekable(in);
  EXPECT_EQ(archive_read_open_filename(in, path.c_str(), 4096), ARCHIVE_OK) << archive_error_string(in);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(in, &entry) == ARCHIVE_OK) {
    std::string content(static_cast<std::size_t>(archive_entry_size(entry)), '\0');
    EXPECT_EQ(archive_read_data(in, content.data(), content.size()), static_cast<la_ssize_t>(content.size()));
    entries.emplace_back(archive_entry_pathname(entry), content);
  }
  archive_read_free(in);
  return entries;
}

TEST_F(Containers, ZipHoldsTheFramesAsTheyAreByNumber) {
  const auto zip = open_container(file(), layout(ContainerKind::zip));
  const std::string large(100'000, 'x');
  zip->add(frame("first", 16));
  zip->add(frame(large));
  zip->add(frame("third"));
  zip->finish();
  const std::vector<std::pair<std::string, std::string>> expected{
      {"frame_0007.jpg", "first"}, {"frame_0008.jpg", large}, {"frame_0009.jpg", "third"}};
  EXPECT_EQ(entries_of(file()), expected);
  EXPECT_THAT(read(file()), HasSubstr(large)) << "stored, not compressed";
}

TEST_F(Containers, ZipNumbersHaveAsManyDigitsAsTheLast) {
  ContainerLayout many = layout(ContainerKind::zip);
  many.first_frame = 99'999, many.frames = 2, many.format = ImageFormat::exr;
  const auto zip = open_container(file(), many);
  zip->add(frame("a"));
  zip->add(frame("b"));
  zip->finish();
  EXPECT_EQ(entries_of(file()).front().first, "frame_099999.exr");
  EXPECT_EQ(entries_of(file()).back().first, "frame_100000.exr");
}

std::uint32_t u32(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value);  // the tests run on little-endian machines
  return value;
}

struct Chunk {
  std::string_view id, content;
};
// The chunks of a RIFF list's content.
std::vector<Chunk> chunks_of(std::string_view bytes) {
  std::vector<Chunk> chunks;
  while (!bytes.empty()) {
    const std::size_t size = bytes.size() < 8 ? bytes.size() : u32(bytes, 4);
    EXPECT_LE(8 + size, bytes.size()) << "a chunk is longer than what holds it";
    if (8 + size > bytes.size()) break;
    chunks.push_back({bytes.substr(0, 4), bytes.substr(8, size)});
    bytes.remove_prefix(std::min(bytes.size(), 8 + size + size % 2));
  }
  return chunks;
}

TEST_F(Containers, AviIsAsItsReferenceSays) {
  const std::vector<std::string> frames{"odd", "four", "another odd"};
  const auto avi = open_container(file(), layout(ContainerKind::avi));
  for (const std::string& each : frames) avi->add(frame(each, 3));
  avi->finish();
  const std::string bytes = read(file());
  ASSERT_EQ(bytes.substr(0, 4), "RIFF");
  EXPECT_EQ(u32(bytes, 4), bytes.size() - 8);
  EXPECT_EQ(bytes.substr(8, 4), "AVI ");
  const auto top = chunks_of(std::string_view(bytes).substr(12));
  ASSERT_EQ(top.size(), 3u);
  ASSERT_EQ(top[0].content.substr(0, 4), "hdrl");
  ASSERT_EQ(top[1].content.substr(0, 4), "movi");
  ASSERT_EQ(top[2].id, "idx1");

  const auto hdrl = chunks_of(top[0].content.substr(4));
  ASSERT_EQ(hdrl.size(), 2u);
  ASSERT_EQ(hdrl[0].id, "avih");
  ASSERT_EQ(hdrl[0].content.size(), 56u);
  EXPECT_EQ(u32(hdrl[0].content, 0), 33'367u) << "microseconds a frame";
  EXPECT_EQ(u32(hdrl[0].content, 16), 3u) << "frames";
  EXPECT_EQ(u32(hdrl[0].content, 24), 1u) << "streams";
  EXPECT_EQ(u32(hdrl[0].content, 32), 640u);
  EXPECT_EQ(u32(hdrl[0].content, 36), 360u);
  const auto strl = chunks_of(hdrl[1].content.substr(4));
  ASSERT_EQ(strl.size(), 2u);
  ASSERT_EQ(strl[0].id, "strh");
  ASSERT_EQ(strl[0].content.size(), 56u);
  EXPECT_EQ(strl[0].content.substr(0, 8), "vidsMJPG");
  EXPECT_DOUBLE_EQ(double(u32(strl[0].content, 24)) / u32(strl[0].content, 20), 29.97);
  EXPECT_EQ(u32(strl[0].content, 32), 3u) << "length in frames";
  ASSERT_EQ(strl[1].id, "strf");
  EXPECT_EQ(strl[1].content.size(), 40u);
  EXPECT_EQ(strl[1].content.substr(16, 4), "MJPG");

  const auto movi = chunks_of(top[1].content.substr(4));
  ASSERT_EQ(movi.size(), 3u);
  ASSERT_EQ(top[2].content.size(), 3u * 16);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(movi[i].id, "00dc");
    EXPECT_EQ(movi[i].content, frames[i]);
    EXPECT_EQ(top[2].content.substr(16 * i, 4), "00dc");
    const std::uint32_t offset = u32(top[2].content, 16 * i + 8), size = u32(top[2].content, 16 * i + 12);
    EXPECT_EQ(top[1].content.substr(offset + 8, size), frames[i]) << "the index counts from the word movi";
  }
}

TEST_F(Containers, AviRefusesOtherFormatsAndWhatMakesItTooLarge) {
  ContainerLayout png = layout(ContainerKind::avi);
  png.format = ImageFormat::png;
  EXPECT_THROW(open_container(file(), png), Error);
  constexpr std::uint64_t max_bytes = 10'000;
  const auto avi = open_avi(file(), layout(ContainerKind::avi), max_bytes);
  int added = 0;
  try {
    for (; added < 100; ++added) avi->add(frame(std::string(999, 'x')));
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("2 GiB"));
  }
  EXPECT_EQ(added, 9);
  avi->finish();
  EXPECT_LE(fs::file_size(file()), max_bytes);
  EXPECT_GT(fs::file_size(file()) + 999 + 25, max_bytes) << "one more frame, its head, padding and index";
}

TEST_F(Containers, WhatIsNotFinishedTakesItsFileWithIt) {
  for (const auto kind : {ContainerKind::zip, ContainerKind::avi}) {
    auto container = open_container(file(), layout(kind));
    container->add(frame("first"));
    EXPECT_TRUE(fs::exists(file()));
    container.reset();
    EXPECT_FALSE(fs::exists(file()));
  }
}

TEST_F(Containers, FolderThatIsNotThereAndDiskThatIsFullAreErrors) {
  for (const auto kind : {ContainerKind::zip, ContainerKind::avi}) {
    EXPECT_THROW(open_container(file("nowhere/result"), layout(kind)), Error);
    if (!fs::exists("/dev/full")) continue;
    fs::create_symlink("/dev/full", file("full"));
    EXPECT_THROW(
        {
          const auto container = open_container(file("full"), layout(kind));
          container->add(frame(std::string(1 << 20, 'x')));
          container->finish();
        },
        Error);
    fs::remove(file("full"));
  }
}

}  // namespace
}  // namespace cloudscape::encode
