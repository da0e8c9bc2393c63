// What TurboJPEG reads back from our JPEGs.
#include <gmock/gmock.h>
#include <turbojpeg.h>

#include <memory>

#include "core/error.h"
#include "frames.h"

namespace cloudscape {
namespace {

struct Decoded {
  int width = 0, height = 0, subsampling = -1;
  std::vector<std::uint8_t> rgb;
};

Decoded decode(const EncodedFrame& encoded) {
  const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
  const unsigned char* image = encoded.bytes.data() + encoded.front;
  const auto size = static_cast<unsigned long>(encoded.bytes.size() - encoded.front);
  Decoded decoded;
  int colour_space = 0;
  EXPECT_EQ(tjDecompressHeader3(decoder.get(), image, size, &decoded.width, &decoded.height, &decoded.subsampling,
                                &colour_space),
            0);
  decoded.rgb.resize(std::size_t{3} * decoded.width * decoded.height);
  EXPECT_EQ(tjDecompress2(decoder.get(), image, size, decoded.rgb.data(), decoded.width, 0, decoded.height, TJPF_RGB,
                          TJFLAG_ACCURATEDCT),
            0);
  return decoded;
}

// The root mean square error of the three channels, 0..255.
double rms_error(const Frame& frame, const Decoded& decoded) {
  double sum = 0;
  for (std::size_t i = 0; i < decoded.rgb.size(); ++i) {
    const double difference = static_cast<double>(frame.display_rgba[i / 3 * 4 + i % 3]) - decoded.rgb[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(decoded.rgb.size()));
}

// Quantizing a DCT coefficient with step q leaves an error of q / sqrt(12), and an orthonormal transform keeps the root
// mean square. The mean step of Annex K's luminance table is 57.6 at quality 50 and scales by (200 - 2 quality) / 100
// above it (IJG), at least 1; chrominance (mean 92) comes back to R, G and B with weights of up to 1.772, and rounding
// to 8 bits twice adds up to 1. Smooth pictures stay far below, since their high coefficients are 0 anyway.
double rms_limit(int quality) {
  const double scale = (200.0 - 2.0 * quality) / 100.0;
  return (std::max(1.0, 57.6 * scale) + 1.772 * std::max(1.0, 92.0 * scale)) / std::sqrt(12.0) + 1.0;
}

Encoding jpeg(int quality, ChromaSubsampling chroma) {
  Encoding encoding = encoding_of(ImageFormat::jpeg);
  encoding.jpeg_quality = quality;
  encoding.chroma = chroma;
  return encoding;
}

TEST(Jpeg, ReadsBackWithinItsQuality) {
  const Frame frame = display_frame({160, 90});
  double worse = 0;
  for (const int quality : {95, 75, 50}) {
    const double error = rms_error(frame, decode(encode::encode(frame, jpeg(quality, ChromaSubsampling::none))));
    EXPECT_LT(error, rms_limit(quality)) << "quality " << quality;
    EXPECT_GT(error, worse) << "quality " << quality << " must lose more than the one above it";
    worse = error;
  }
  EXPECT_LT(rms_error(frame, decode(encode::encode(frame, jpeg(95, ChromaSubsampling::none)))), 2.0);
}

TEST(Jpeg, TopRowComesFirstAndRedIsRed) {
  Frame frame = empty_frame({32, 32});
  for (int i = 0; i < 32 * 32; ++i)
    for (const int value : {i < 32 * 16 ? 250 : 10, 60, 120, 255})
      frame.display_rgba.push_back(static_cast<std::uint8_t>(value));
  const Decoded decoded = decode(encode::encode(frame, jpeg(95, ChromaSubsampling::none)));
  EXPECT_NEAR(decoded.rgb[0], 250, 4);
  EXPECT_NEAR(decoded.rgb[2], 120, 4);
  EXPECT_NEAR(decoded.rgb[decoded.rgb.size() - 3], 10, 4);
}

TEST(Jpeg, ChromaIsSampledAsAsked) {
  const Frame frame = display_frame({64, 48});
  const EncodedFrame half = encode::encode(frame, jpeg(90, ChromaSubsampling::half));
  const EncodedFrame whole = encode::encode(frame, jpeg(90, ChromaSubsampling::none));
  EXPECT_EQ(decode(half).subsampling, TJSAMP_420);
  EXPECT_EQ(decode(whole).subsampling, TJSAMP_444);
  EXPECT_LT(half.bytes.size(), whole.bytes.size());
}

TEST(Jpeg, OddSizesKeepTheirSize) {
  for (const ImageSize size_px : {ImageSize{1, 1}, ImageSize{3, 5}, ImageSize{17, 1}})
    for (const auto chroma : {ChromaSubsampling::half, ChromaSubsampling::none}) {
      const Decoded decoded = decode(encode::encode(display_frame(size_px), jpeg(90, chroma)));
      EXPECT_EQ(decoded.width, size_px.width);
      EXPECT_EQ(decoded.height, size_px.height);
    }
}

// One compressor serves all the pictures of a thread: a large one before must not show in a small one after.
TEST(Jpeg, TheCompressorForgetsThePictureBefore) {
  const Encoding encoding = jpeg(90, ChromaSubsampling::half);
  const auto alone = encode::encode(display_frame({3, 5}), encoding).bytes;
  encode::encode(display_frame({300, 200}), encoding);
  EXPECT_EQ(encode::encode(display_frame({3, 5}), encoding).bytes, alone);
}

TEST(Jpeg, RefusesAQualityThatJpegHasNot) {
  EXPECT_THAT(
      [] {
        encode::encode(display_frame({4, 4}), jpeg(101, ChromaSubsampling::none));
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("JPEG")));
}

}  // namespace
}  // namespace cloudscape
