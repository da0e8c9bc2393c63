// The binary header: its bytes, and what is refused.
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/unit/settings/refusal.h"
#include "wire/messages.h"

namespace cloudscape::wire {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

FrameHeader sample() {
  FrameHeader header;
  header.quality_stage = 255;
  header.lens_kind = 3;
  header.frame_id = 0x01020304;
  header.pose_sequence = 0x1122334455667788;
  header.width_px = 0x0A0B;
  header.height_px = 720;
  header.vertical_fov_deg = 1.0f;
  header.position_m[0] = -2.0;
  header.position_m[2] = 1e-300;
  header.azimuth_deg = 359.9;
  header.time_s = -1;
  header.encode_ms = 0.5f;
  header.image_bytes = 2;
  return header;
}

Bytes message_of(const FrameHeader& header) {
  Bytes bytes(frame_header_bytes + header.image_bytes);
  write(header, std::span<std::uint8_t, frame_header_bytes>(bytes.data(), frame_header_bytes));
  return bytes;
}

std::string sentence(const Bytes& bytes) {
  return refusal<Error>([&] { read_frame_header(bytes); }).sentence;
}

TEST(FrameHeaders, AreWrittenAsTheyAreRead) { EXPECT_EQ(read_frame_header(message_of(sample())), sample()); }

// Offsets by hand from the order in messages.h: what clients in other languages read.
TEST(FrameHeaders, HaveTheirBytesInPlaceLittleEndFirst) {
  const Bytes bytes = message_of(sample());
  const auto at = [&](std::size_t first, std::size_t count) {
    return Bytes(bytes.begin() + first, bytes.begin() + first + count);
  };
  EXPECT_EQ(frame_header_bytes, 92u);
  EXPECT_EQ(at(0, 4), (Bytes{1, 255, 0, 3}));
  EXPECT_EQ(at(4, 4), (Bytes{4, 3, 2, 1}));
  EXPECT_EQ(at(8, 8), (Bytes{0x88, 0x77, 0x66, 0x55, 0x44, 0x33, 0x22, 0x11}));
  EXPECT_EQ(at(16, 4), (Bytes{0x0B, 0x0A, 0xD0, 0x02}));
  EXPECT_EQ(at(20, 4), (Bytes{0, 0, 0x80, 0x3F})) << "1.0f";
  EXPECT_EQ(at(24, 8), (Bytes{0, 0, 0, 0, 0, 0, 0, 0xC0})) << "-2.0";
  EXPECT_EQ(at(72, 8), (Bytes{0, 0, 0, 0, 0, 0, 0xF0, 0xBF})) << "time_s -1.0";
  EXPECT_EQ(at(84, 4), (Bytes{0, 0, 0, 0x3F})) << "encode_ms 0.5f";
  EXPECT_EQ(at(88, 4), (Bytes{2, 0, 0, 0}));
}

TEST(FrameHeaders, SayWhatTheFrameWasRenderedWith) {
  Frame frame;
  frame.request.pose = {{1, 2, 3}, 4, 5, 6};
  frame.request.lens = {LensKind::fisheye, 70, 1};
  frame.request.size_px = {1280, 720};
  frame.request.time_s = 8;
  frame.timings.render_ms = 12.5;
  const FrameHeader header = frame_header(frame, 9, 10, 11, 2.5, 1000);
  FrameHeader expected;
  expected.quality_stage = 11;
  expected.lens_kind = 3;
  expected.frame_id = 9;
  expected.pose_sequence = 10;
  expected.width_px = 1280;
  expected.height_px = 720;
  expected.vertical_fov_deg = 70;
  expected.position_m[0] = 1, expected.position_m[1] = 2, expected.position_m[2] = 3;
  expected.azimuth_deg = 4, expected.elevation_deg = 5, expected.roll_deg = 6;
  expected.time_s = 8;
  expected.render_ms = 12.5f, expected.encode_ms = 2.5f;
  expected.image_bytes = 1000;
  EXPECT_EQ(header, expected);
}

TEST(FrameHeaders, AreRefusedWithOneSentence) {
  Bytes bytes = message_of(sample());
  EXPECT_EQ(sentence({}), "the frame has 0 bytes: its header alone has 92");
  EXPECT_THAT(sentence(Bytes(bytes.begin(), bytes.begin() + 91)), HasSubstr("has 91 bytes"));
  EXPECT_EQ(sentence(Bytes(bytes.begin(), bytes.end() - 1)), "the frame has 1 bytes of image, its header says 2");
  bytes.push_back(0);
  EXPECT_EQ(sentence(bytes), "the frame has 3 bytes of image, its header says 2");
  const auto with = [](std::size_t index, std::uint8_t value) {
    Bytes changed = message_of(sample());
    changed[index] = value;
    return sentence(changed);
  };
  EXPECT_THAT(with(0, 2), HasSubstr("version 2"));
  EXPECT_THAT(with(2, 3), HasSubstr("image format 3"));
  EXPECT_THAT(with(3, 4), HasSubstr("lens 4"));
  FrameHeader not_finite = sample();
  not_finite.elevation_deg = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(sentence(message_of(not_finite)), HasSubstr("not finite"));
}

TEST(FrameHeaders, DamagedOnesAreRefusedOrReadAndNothingElse) {
  std::mt19937 random(5);
  for (int round = 0; round < 20000; ++round) {
    Bytes bytes = message_of(sample());
    bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    bytes.resize(random() % 3 ? bytes.size() : random() % 120);
    try {
      read_frame_header(bytes);
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace cloudscape::wire
