// What holds for every format: the room in front, refusals, equal bytes, many threads.
#include "encode/encode.h"

#include <gmock/gmock.h>

#include <thread>

#include "core/error.h"
#include "frames.h"

namespace cloudscape {
namespace {

constexpr ImageFormat formats[] = {ImageFormat::jpeg, ImageFormat::png, ImageFormat::exr};

Frame frame_for(ImageFormat format, ImageSize size_px) {
  return format == ImageFormat::exr ? radiance_frame(size_px) : display_frame(size_px);
}

TEST(Encode, LeavesRoomInFrontAndChangesNothingElse) {
  for (const ImageFormat format : formats) {
    const Frame frame = frame_for(format, {31, 17});
    const EncodedFrame plain = encode::encode(frame, encoding_of(format));
    const EncodedFrame roomy = encode::encode(frame, encoding_of(format), 108);
    ASSERT_EQ(roomy.bytes.size(), plain.bytes.size() + 108);
    EXPECT_EQ(roomy.front, 108u);
    EXPECT_EQ(roomy.format, format);
    EXPECT_THAT(std::vector(roomy.bytes.begin(), roomy.bytes.begin() + 108), testing::Each(0));
    EXPECT_TRUE(std::equal(plain.bytes.begin(), plain.bytes.end(), roomy.bytes.begin() + 108));
    EXPECT_GT(roomy.encode_ms, 0.0);
  }
}

TEST(Encode, EqualFramesMakeEqualBytes) {
  for (const ImageFormat format : formats)
    EXPECT_EQ(encode::encode(frame_for(format, {64, 48}), encoding_of(format)).bytes,
              encode::encode(frame_for(format, {64, 48}), encoding_of(format)).bytes)
        << name_of(format);
}

TEST(Encode, RefusesAFrameThatHoldsTheOtherContent) {
  for (const ImageFormat format : formats) {
    const ImageFormat other = format == ImageFormat::exr ? ImageFormat::png : ImageFormat::exr;
    EXPECT_THAT(
        [&] {
          encode::encode(frame_for(other, {4, 4}), encoding_of(format));
        },
        testing::ThrowsMessage<Error>(testing::HasSubstr(format == ImageFormat::exr ? "radiance" : "display")));
  }
}

TEST(Encode, RefusesAFrameWhoseSizeIsNotThatOfItsPixels) {
  for (const ImageFormat format : formats) {
    Frame frame = frame_for(format, {4, 4});
    frame.request.size_px = {4, 5};
    EXPECT_THROW(encode::encode(frame, encoding_of(format)), Error);
    frame.request.size_px = {0, 0};
    EXPECT_THROW(encode::encode(frame, encoding_of(format)), Error);
  }
  Frame shallow = radiance_frame({4, 4});
  shallow.depth_m.pop_back();
  EXPECT_THROW(encode::encode(shallow, encoding_of(ImageFormat::exr)), Error);
}

TEST(Encode, RefusesAnExrWithoutItsDocument) {
  Frame frame = radiance_frame({4, 4});
  frame.request.cloudscape = nullptr;
  EXPECT_THROW(encode::encode(frame, encoding_of(ImageFormat::exr)), Error);
}

TEST(Encode, FourThreadsAtOnceMakeWhatOneMakes) {
  constexpr int threads = 4, rounds = 20;
  const auto frame_of = [](ImageFormat format, int thread) { return frame_for(format, {40 + thread, 30}); };
  std::vector<int> wrong(threads, 0);
  std::vector<std::jthread> pool;
  for (int thread = 0; thread < threads; ++thread)
    pool.emplace_back([&, thread] {
      for (const ImageFormat format : formats) {
        const auto first = encode::encode(frame_of(format, thread), encoding_of(format)).bytes;
        for (int round = 1; round < rounds; ++round)
          wrong[thread] += encode::encode(frame_of(format, thread), encoding_of(format)).bytes != first;
      }
    });
  pool.clear();
  EXPECT_THAT(wrong, testing::Each(0));
  // The main thread, alone, agrees with what the pool's threads called their first.
  for (const ImageFormat format : formats) {
    std::vector<std::uint8_t> other;
    std::jthread([&] { other = encode::encode(frame_of(format, 2), encoding_of(format)).bytes; }).join();
    EXPECT_EQ(encode::encode(frame_of(format, 2), encoding_of(format)).bytes, other);
  }
}

TEST(Encode, NamesItsMediaTypes) {
  EXPECT_STREQ(encode::media_type(ImageFormat::jpeg), "image/jpeg");
  EXPECT_STREQ(encode::media_type(ImageFormat::png), "image/png");
  EXPECT_STREQ(encode::media_type(ImageFormat::exr), "image/x-exr");
}

}  // namespace
}  // namespace cloudscape
