// What OpenEXR reads back from our EXRs.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <gtest/gtest.h>

#include <cstring>

#include "core/content_hash.h"
#include "core/error.h"
#include "core/version.h"
#include "frames.h"

namespace cloudscape {
namespace {

class MemoryFile : public Imf::IStream {
 public:
  explicit MemoryFile(const EncodedFrame& encoded) : IStream("memory"), encoded_(encoded) {}
  bool read(char out[], int size) override {
    if (encoded_.front + position_ + size > encoded_.bytes.size()) throw std::runtime_error("the file ends early");
    std::memcpy(out, encoded_.bytes.data() + encoded_.front + position_, size);
    position_ += size;
    return encoded_.front + position_ < encoded_.bytes.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const EncodedFrame& encoded_;
  std::uint64_t position_ = 0;
};

struct Decoded {
  Imf::Header header;
  std::vector<float> rgba, depth_m;
};

Decoded decode(const EncodedFrame& encoded) {
  MemoryFile memory(encoded);
  Imf::InputFile file(memory);
  const Imath::Box2i window = file.header().dataWindow();
  const std::size_t width = window.max.x + 1, height = window.max.y + 1;
  Decoded decoded{file.header(), std::vector<float>(width * height * 4), std::vector<float>(width * height)};
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < 4; ++c)
    buffer.insert(std::string(1, "RGBA"[c]),
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(decoded.rgba.data() + c), 16, 16 * width));
  buffer.insert("Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(decoded.depth_m.data()), 4, 4 * width));
  file.setFrameBuffer(buffer);
  file.readPixels(0, static_cast<int>(height) - 1);
  return decoded;
}

Encoding exr(ExrType type) {
  Encoding encoding = encoding_of(ImageFormat::exr);
  encoding.exr_type = type;
  return encoding;
}

double number(const Imf::Header& header, const char* name) {
  return header.typedAttribute<Imf::DoubleAttribute>(name).value();
}
int integer(const Imf::Header& header, const char* name) {
  return header.typedAttribute<Imf::IntAttribute>(name).value();
}
std::string text(const Imf::Header& header, const char* name) {
  return header.typedAttribute<Imf::StringAttribute>(name).value();
}

TEST(Exr, FloatsReadBackExactlyInEverySize) {
  for (const ImageSize size_px : {ImageSize{64, 36}, ImageSize{1, 1}, ImageSize{3, 5}}) {
    const Frame frame = radiance_frame(size_px);
    const Decoded decoded = decode(encode::encode(frame, exr(ExrType::float32)));
    EXPECT_EQ(decoded.rgba, frame.radiance_rgba);
    EXPECT_EQ(decoded.depth_m, frame.depth_m);
  }
}

// A half has 11 significant bits: rounding to nearest errs by at most 2^-11 of the value.
TEST(Exr, HalvesRoundToNearestAndKeepInfinity) {
  for (const ImageSize size_px : {ImageSize{64, 36}, ImageSize{1, 1}, ImageSize{3, 5}}) {
    const Frame frame = radiance_frame(size_px);
    const Decoded decoded = decode(encode::encode(frame, exr(ExrType::half)));
    ASSERT_EQ(decoded.rgba.size(), frame.radiance_rgba.size());
    for (std::size_t i = 0; i < decoded.rgba.size(); ++i)
      ASSERT_NEAR(decoded.rgba[i], frame.radiance_rgba[i], frame.radiance_rgba[i] * 0x1p-11f);
    EXPECT_EQ(decoded.depth_m, frame.depth_m) << "32 bit, infinity included";
  }
}

TEST(Exr, HalvesStayFiniteBeyondTheirRange) {
  Frame frame = radiance_frame({2, 1});
  frame.radiance_rgba = {1e6f, 65504.0f, 65519.9f, 1.0f, -1e9f, 70000.0f, 0.0f, 0.0f};
  frame.depth_m = {250000.0f, std::numeric_limits<float>::infinity()};
  const Decoded decoded = decode(encode::encode(frame, exr(ExrType::half)));
  EXPECT_EQ(decoded.rgba, (std::vector<float>{65504, 65504, 65504, 1, -65504, 65504, 0, 0}));
  EXPECT_EQ(decoded.depth_m[0], 250000.0f) << "the horizon from an airliner is farther than half reaches";
  EXPECT_TRUE(std::isinf(decoded.depth_m[1]));
}

TEST(Exr, ChannelsHaveTheTypeThatWasAsked) {
  for (const auto& [type, pixel_type] :
       {std::pair{ExrType::half, Imf::HALF}, std::pair{ExrType::float32, Imf::FLOAT}}) {
    const Decoded decoded = decode(encode::encode(radiance_frame({8, 8}), exr(type)));
    std::string names;
    const Imf::ChannelList& channels = decoded.header.channels();
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
      names += channel.name();
      EXPECT_EQ(channel.channel().type, std::string(channel.name()) == "Z" ? Imf::FLOAT : pixel_type);
    }
    EXPECT_EQ(names, "ABGRZ");
    EXPECT_EQ(decoded.header.compression(), Imf::ZIP_COMPRESSION);
  }
}

TEST(Exr, TellsHowItWasMade) {
  Frame frame = radiance_frame({4, 4});
  auto cloudscape = std::make_shared<Cloudscape>();
  cloudscape->seed = 99;
  cloudscape->sun.azimuth_deg = 211.25;
  cloudscape->sun.elevation_deg = -3.5;
  cloudscape->sun.irradiance = {1.5, 2.5, 0.25};
  frame.request.cloudscape = cloudscape;
  frame.request.pose = {{1234567.125, -0.0625, 2500.0}, 359.9, -12.3, 4.5};
  frame.request.lens.vertical_fov_deg = 33.25;
  frame.request.display.exposure_ev = -1.5;
  frame.request.quality = render_quality(Quality::high);
  frame.request.time_s = 86400.5;
  frame.samples = 24;
  const Imf::Header header = decode(encode::encode(frame, exr(ExrType::half))).header;
  EXPECT_EQ(number(header, "camera_east_m"), 1234567.125);
  EXPECT_EQ(number(header, "camera_north_m"), -0.0625);
  EXPECT_EQ(number(header, "camera_altitude_m"), 2500.0);
  EXPECT_EQ(number(header, "camera_azimuth_deg"), 359.9);
  EXPECT_EQ(number(header, "camera_elevation_deg"), -12.3);
  EXPECT_EQ(number(header, "camera_roll_deg"), 4.5);
  EXPECT_EQ(text(header, "lens_kind"), "perspective");
  EXPECT_EQ(number(header, "lens_vertical_fov_deg"), 33.25);
  EXPECT_EQ(number(header, "sun_azimuth_deg"), 211.25);
  EXPECT_EQ(number(header, "sun_elevation_deg"), -3.5);
  EXPECT_EQ(header.typedAttribute<Imf::V3fAttribute>("sun_irradiance").value(), Imath::V3f(1.5f, 2.5f, 0.25f));
  EXPECT_EQ(number(header, "time_s"), 86400.5);
  EXPECT_EQ(number(header, "exposure_ev"), -1.5);
  EXPECT_EQ(integer(header, "samples"), 24);
  EXPECT_EQ(integer(header, "quality_max_steps"), frame.request.quality.max_steps);
  EXPECT_EQ(number(header, "quality_step_m"), frame.request.quality.step_m);
  EXPECT_EQ(integer(header, "quality_light_steps"), frame.request.quality.light_steps);
  EXPECT_EQ(text(header, "cloudscape_hash"), content_hash(*cloudscape));
  EXPECT_EQ(text(header, "software"), std::string("cloudscape ") + version);
}

TEST(Exr, DescribesEachLensByWhatItHas) {
  Frame frame = radiance_frame({4, 2});
  frame.request.lens.kind = LensKind::panorama;
  const Imf::Header panorama = decode(encode::encode(frame, exr(ExrType::half))).header;
  EXPECT_EQ(Imf::envmap(panorama), Imf::ENVMAP_LATLONG);
  EXPECT_EQ(panorama.findTypedAttribute<Imf::DoubleAttribute>("lens_vertical_fov_deg"), nullptr);
  frame.request.lens = {LensKind::orthographic, 50.0, 4321.0};
  const Imf::Header orthographic = decode(encode::encode(frame, exr(ExrType::half))).header;
  EXPECT_EQ(number(orthographic, "lens_width_m"), 4321.0);
  EXPECT_FALSE(Imf::hasEnvmap(orthographic));
}

// Of a path-traced picture: three channels more, of 32 bits whatever the colours have.
TEST(Exr, HoldsTheStandardErrorOfTracedPictures) {
  Frame frame = radiance_frame({5, 3});
  EXPECT_FALSE(decode(encode::encode(frame, exr(ExrType::half))).header.channels().findChannel("stderr.R"));
  for (int i = 0; i < 45; ++i) frame.standard_error_rgb.push_back(1e-7F * static_cast<float>(i));
  const EncodedFrame encoded = encode::encode(frame, exr(ExrType::half));
  MemoryFile memory(encoded);
  Imf::InputFile file(memory);
  std::vector<float> error(45);
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < 3; ++c)
    buffer.insert(std::string("stderr.") + "RGB"[c],
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(error.data() + c), 12, 12 * 5));
  file.setFrameBuffer(buffer);
  file.readPixels(0, 2);
  EXPECT_EQ(error, frame.standard_error_rgb);
  frame.standard_error_rgb.pop_back();
  EXPECT_THROW(encode::encode(frame, exr(ExrType::half)), Error);
}

TEST(Exr, SaysHowAPictureWasTraced) {
  Frame frame = radiance_frame({2, 2});
  frame.request.quality = render_quality(Quality::reference);
  frame.request.tracing.seed = 4294967295;
  frame.request.tracing.atmosphere = TracedAtmosphere::traced;
  frame.request.tracing.max_scattering_order = 3;
  const Imf::Header header = decode(encode::encode(frame, exr(ExrType::half))).header;
  EXPECT_EQ(number(header, "trace_seed"), 4294967295.0);
  EXPECT_EQ(text(header, "trace_atmosphere"), "traced");
  EXPECT_EQ(integer(header, "trace_max_scattering_order"), 3);
  EXPECT_EQ(header.find("quality_max_steps"), header.end());
}

}  // namespace
}  // namespace cloudscape
