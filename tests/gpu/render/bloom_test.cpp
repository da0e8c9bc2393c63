// The glow of made-up pictures against its closed form, and of real ones: what glows, how far, how much, and what not.
#include "render/bloom.h"

#include <algorithm>
#include <functional>

#include "fixture.h"
#include "gpu/gpu/fixture.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

constexpr double threshold = 8, bound = 0.4;  // shaders/lib/bloom.glsl

// The finest level of the glow; a texel covers `side` pixels of the picture (whole ones in these tests).
struct Glow {
  int width = 0, height = 0;
  double side = 1;
  std::vector<float> rgba;
  double at(int x, int y) const { return rgba[4 * (static_cast<std::size_t>(y) * width + x)]; }
  // As the tone map reads it for the middle of a pixel.
  double shown(int px, int py) const {
    const auto sample = [&](double pixel, int last, int& first) {
      const double texel = std::clamp((pixel + 0.5) / side - 0.5, 0.0, static_cast<double>(last));
      first = std::min(static_cast<int>(texel), std::max(0, last - 1));
      return texel - first;
    };
    int x = 0, y = 0;
    const double right = sample(px, width - 1, x), down = sample(py, height - 1, y);
    return std::lerp(std::lerp(at(x, y), at(x + 1, y), right), std::lerp(at(x, y + 1), at(x + 1, y + 1), right), down);
  }
  // In the unit of the total: luminance times area in heights^2.
  double total() const {
    double sum = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) sum += rgba[i];
    return sum / height / height;
  }
};

using Picture = std::function<double(double x, double y)>;  // grey radiance at a pixel's middle, in heights

class BloomTest : public RenderTest {
 protected:
  static FrameRequest request(ImageSize size_px, LensKind lens = LensKind::perspective) {
    FrameRequest request = picture(empty_world(), {}, size_px);
    request.display = {.exposure_ev = 0, .bloom_strength = 1, .bloom_threshold = threshold, .bloom_radius = 0.08};
    request.lens.kind = lens;
    return request;
  }
  static Glow glow(const FrameRequest& request, const Picture& picture) {
    const ImageSize size = request.size_px;
    std::vector<float> pixels;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const auto value = static_cast<float>(picture((x + 0.5) / size.height, (y + 0.5) / size.height));
        pixels.insert(pixels.end(), {value, value, value, 0});
      }
    gpu::Texture radiance(gpu::Format::rgba32f, size.width, size.height, "made-up picture");
    radiance.upload({reinterpret_cast<const std::uint8_t*>(pixels.data()), pixels.size() * sizeof(float)});
    gpu::UniformBlock<FrameBlock> block("frame");
    block.upload(frame_block(request, 0));
    block.bind();
    const Bloom bloom(stack().context, stack().shaders);
    const BloomChain chain(size, request.display.bloom_radius, request.lens.kind == LensKind::panorama);
    const gpu::Texture& found = bloom.glow(chain, radiance);
    return {found.width(), found.height(), static_cast<double>(size.height) / found.height(),
            gpu::as_numbers<float>(found.download())};
  }
};

Picture disc(double x, double y, double radius, double luminance, double ground = 0) {
  return [=](double px, double py) { return std::hypot(px - x, py - y) <= radius ? luminance : ground; };
}

// What a light of total 1 adds at a distance, in heights.
double closed_form(double distance, double radius) {
  double sum = 0;
  for (const GlowGaussian& gaussian : glow_gaussians) {
    const double variance = std::pow(gaussian.deviation * radius, 2);
    sum += gaussian.share * std::exp(-0.5 * distance * distance / variance) / (2 * std::numbers::pi * variance);
  }
  return sum;
}

// As its pixels have it, in the unit of the total.
double light_above_threshold(const Picture& picture, ImageSize size) {
  double above = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      above += std::max(0.0, picture((x + 0.5) / size.height, (y + 0.5) / size.height) - threshold);
  return above / size.height / size.height;
}

double bounded(double total) { return total / (1 + total / bound); }

constexpr ImageSize sizes[] = {{320, 180}, {640, 360}, {1280, 720}, {384, 216}, {200, 540}};

struct BrightPixel {
  double x, y, light;  // heights; luminance times area
};
std::vector<BrightPixel> bright_pixels(const Picture& picture, ImageSize size) {
  std::vector<BrightPixel> bright;
  const double height = size.height;
  for (int py = 0; py < size.height; ++py)
    for (int px = 0; px < size.width; ++px) {
      const double x = (px + 0.5) / height, y = (py + 0.5) / height, excess = picture(x, y) - threshold;
      if (excess > 0) bright.push_back({x, y, excess / height / height});
    }
  return bright;
}

// The closed form about each bright pixel, summed at a point.
double expected_glow(const std::vector<BrightPixel>& bright, double radius, double x, double y) {
  double sum = 0;
  for (const BrightPixel& pixel : bright)
    sum += pixel.light * closed_form(std::hypot(pixel.x - x, pixel.y - y), radius);
  return sum;
}

// Tolerance: 8 % of the peak, for Gaussians of little more than a texel: where in its texel a light stands, and odd
// sizes, shift that much between neighbours.
TEST_F(BloomTest, HasTheProfileOfItsGaussiansAtEachSize) {
  for (const ImageSize size : sizes)
    for (const double radius : {0.05, 0.08, 0.15}) {
      FrameRequest asked = request(size);
      asked.display.bloom_radius = radius;
      const double x = 0.5 * size.width / size.height, height = size.height;
      const Picture picture = disc(x, 0.5, 0.01, threshold + 10);
      const Glow found = glow(asked, picture);
      const std::vector<BrightPixel> bright = bright_pixels(picture, size);
      const double total = light_above_threshold(picture, size), scale = bounded(total) / total;
      const double peak = scale * expected_glow(bright, radius, x, 0.5);
      // To the right, downwards, and between: half a height far.
      for (const auto& [right, down] : {std::pair(1, 0), std::pair(0, 1), std::pair(2, 1)})
        for (int step = 0; step < size.height / 4 && step * right < size.width / 2; step += 1 + size.height / 180) {
          const int px = size.width / 2 + step * right, py = std::min(size.height - 1, size.height / 2 + step * down);
          const double expected = scale * expected_glow(bright, radius, (px + 0.5) / height, (py + 0.5) / height);
          ASSERT_NEAR(found.shown(px, py), expected, 0.08 * peak)
              << size.width << "x" << size.height << ", radius " << radius << ", pixel " << px << ' ' << py;
        }
    }
}

TEST_F(BloomTest, IsSymmetric) {
  const Glow found = glow(request({640, 360}), disc(320.0 / 360, 0.5, 0.03, 100));
  for (int j = 0; j < found.height; ++j)
    for (int i = 0; i < found.width; ++i) {
      const double tolerance = 4e-3 * found.at(i, j) + 1e-7;  // a GPU filters with weights of 8 bits
      ASSERT_NEAR(found.at(i, j), found.at(found.width - 1 - i, j), tolerance);
      ASSERT_NEAR(found.at(i, j), found.at(i, found.height - 1 - j), tolerance);
    }
}

// Narrow enough that nothing falls over the picture's edge.
TEST_F(BloomTest, AddsTheLightAboveTheThresholdTimesTheStrength) {
  for (const ImageSize size : {ImageSize{320, 180}, ImageSize{1280, 720}, ImageSize{333, 251}})
    for (const double strength : {0.06, 0.5, 1.0}) {
      FrameRequest asked = request(size);
      asked.display.bloom_strength = strength;
      const Picture picture = disc(0.5 * size.width / size.height, 0.5, 0.05, threshold + 0.3, threshold);
      const double above = light_above_threshold(picture, size);
      EXPECT_NEAR(glow(asked, picture).total() / (strength * bounded(above)), 1, 0.01) << size.width << ' ' << strength;
    }
}

TEST_F(BloomTest, NeverAddsMoreThanItsBound) {
  for (const double luminance : {1e3, 1e6, 1e30})
    EXPECT_LE(glow(request({320, 180}), disc(0.9, 0.5, 0.02, luminance)).total(), bound * 1.01);
  EXPECT_GT(glow(request({320, 180}), disc(0.9, 0.5, 0.02, 1e30)).total(), bound * 0.98);
}

// A sun of a pixel or two moves over the picture: it covers the middles of one to four pixels. The bound leaves a sixth
// of that change.
TEST_F(BloomTest, DoesNotPumpWithThePixelsThatASmallSunCovers) {
  constexpr double sun_radius = 0.005, sun_luminance = 60000;
  double least = 1e9, most = 0;
  for (int step = 0; step < 12; ++step) {
    const double shift = step / 12.0 / 180;
    const double total =
        glow(request({320, 180}), disc(0.9 + shift, 0.5 + 0.7 * shift, sun_radius, sun_luminance)).total();
    least = std::min(least, total), most = std::max(most, total);
  }
  EXPECT_LT(most / least, 1.2);
  const double large = glow(request({1280, 720}), disc(0.9, 0.5, sun_radius, sun_luminance)).total();
  EXPECT_NEAR(large / most, 1, 0.1);
}

TEST_F(BloomTest, LeavesWhatIsBelowTheThresholdAlone) {
  const Glow none =
      glow(request({640, 360}), [](double x, double y) { return threshold * (0.5 + 0.5 * std::sin(9 * x * y)); });
  EXPECT_EQ(*std::max_element(none.rgba.begin(), none.rgba.end()), 0);
  EXPECT_EQ(*std::min_element(none.rgba.begin(), none.rgba.end()), 0);
}

// Left and right of a panorama are neighbours, in whatever texels its width is divided; of other pictures they are not.
TEST_F(BloomTest, GoesOnAtTheOtherSideOfAPanorama) {
  for (const ImageSize size : {ImageSize{360, 180}, ImageSize{500, 250}, ImageSize{728, 364}}) {
    const double width = static_cast<double>(size.width) / size.height;
    const Picture at_the_edge = [&](double x, double y) { return disc(0, 0.5, 0.03, 20)(std::min(x, width - x), y); };
    const Glow middle = glow(request(size), disc(width / 2, 0.5, 0.03, 20));
    const Glow wrapped = glow(request(size, LensKind::panorama), at_the_edge);
    const Glow cut = glow(request(size), disc(0, 0.5, 0.03, 20));
    const double peak = *std::max_element(middle.rgba.begin(), middle.rgba.end());
    for (int j = 0; j < middle.height; ++j)
      for (int i = 0; i < middle.width; ++i)
        ASSERT_NEAR(wrapped.at((i + middle.width / 2) % middle.width, j), middle.at(i, j), 0.05 * peak)
            << i << ' ' << j;
    EXPECT_EQ(cut.at(cut.width - 1, cut.height / 2), 0) << size.width;
  }
}

TEST_F(BloomTest, WorksInPicturesOfAnyShape) {
  for (const ImageSize size :
       {ImageSize{1, 1}, ImageSize{3, 2}, ImageSize{500, 1}, ImageSize{1, 500}, ImageSize{271, 269}})
    for (const double radius : {0.02, 0.5}) {
      FrameRequest asked = request(size);
      asked.display.bloom_radius = radius;
      const Glow found = glow(asked, [](double, double) { return 1000.0; });
      for (const float value : found.rgba)
        ASSERT_TRUE(std::isfinite(value) && value >= 0) << size.width << "x" << size.height;
    }
}

// The filters before and after the kernel have up to a third of a texel squared; the profile above holds the sum.
TEST(BloomPlan, LeavesTheKernelItsShareOfEachVariance) {
  for (const int height : {90, 180, 250, 720, 1080, 4096})
    for (const double radius : {0.05, 0.08, 0.3}) {
      const BloomPlan plan = bloom_plan({height * 16 / 9, height}, radius);
      ASSERT_EQ(plan.blurs.size(), glow_gaussians.size());
      for (std::size_t i = 0; i < plan.blurs.size(); ++i) {
        const BloomBlur& blur = plan.blurs[i];
        const double texel_px = static_cast<double>(height) / plan.sizes[static_cast<std::size_t>(blur.level)].height;
        const double wanted = std::pow(glow_gaussians[i].deviation * radius * height / texel_px, 2);
        double sum = blur.vertical[0], variance = 0;
        for (int d = 1; d < 8; ++d) {
          sum += 2 * blur.vertical[static_cast<std::size_t>(d)];
          variance += 2 * blur.vertical[static_cast<std::size_t>(d)] * d * d;
        }
        EXPECT_NEAR(sum, 1, 1e-12);
        EXPECT_LE(variance, wanted + 0.01) << height << ' ' << radius << ' ' << i;
        EXPECT_GE(variance, 0.95 * wanted - 1.0 / 3) << height << ' ' << radius << ' ' << i;
        if (i > 0) {
          EXPECT_GT(blur.level, plan.blurs[i - 1].level);
        }
      }
      EXPECT_LE(plan.sizes.back().width * plan.sizes.back().height, 512);
      EXPECT_LE(plan.sizes.front().height, 270);
    }
}

// A bright sun in a dark sky.
Cloudscape sun_alone() {
  Cloudscape sky = empty_world();
  sky.sun.disc = true;
  sky.sun.angular_radius_deg = 0.5;
  sky.sun.azimuth_deg = 0, sky.sun.elevation_deg = 20;
  return sky;
}

FrameRequest display_of(const Cloudscape& sky, LensKind lens = LensKind::perspective) {
  FrameRequest request = picture(sky, {camera_m, 0, 20, 0}, {161, 91});
  request.content = FrameContent::display;
  request.lens.kind = lens;
  request.display.dither = false;
  return request;
}

std::uint8_t shown_at(const Frame& frame, int x, int y) {
  return frame.display_rgba[4 * (static_cast<std::size_t>(y) * frame.request.size_px.width + x)];
}

TEST_F(BloomTest, MakesTheSunGlowAndFadeOutwards) {
  const Frame frame = render(display_of(sun_alone()));
  EXPECT_EQ(shown_at(frame, 80, 45), 255);
  for (int x = 81; x < 110; ++x) EXPECT_LE(shown_at(frame, x, 45), shown_at(frame, x - 1, 45)) << x;
  EXPECT_GT(shown_at(frame, 86, 45), 20);
  EXPECT_EQ(shown_at(frame, 160, 0), 0);
}

TEST_F(BloomTest, IsSkippedAtStrengthNought) {
  FrameRequest plain = display_of(sun_alone());
  plain.display.bloom_strength = 0;
  const Frame without = render(plain);
  plain.display.bloom_threshold = 0, plain.display.bloom_radius = 0.3;
  EXPECT_EQ(render(plain).display_rgba, without.display_rgba);
  EXPECT_EQ(shown_at(without, 86, 45), 0);
  // Nor does it change what has nothing to glow.
  Cloudscape clouds = small_clouds();
  FrameRequest dull = display_of(clouds);
  dull.display.bloom_threshold = 1e6;
  const Frame glowless = render(dull);
  dull.display.bloom_strength = 0;
  EXPECT_EQ(render(dull).display_rgba, glowless.display_rgba);
}

TEST_F(BloomTest, IsNoPartOfTheRadiance) {
  FrameRequest asked = display_of(sun_alone());
  asked.content = FrameContent::radiance;
  const Frame with = render(asked);
  asked.display.bloom_strength = 0;
  EXPECT_EQ(render(asked).radiance_rgba, with.radiance_rgba);
}

TEST_F(BloomTest, StaysInsideTheCircleOfTheFisheye) {
  FrameRequest asked = display_of(sun_alone(), LensKind::fisheye);
  asked.display.bloom_strength = 1, asked.display.bloom_threshold = 0, asked.display.bloom_radius = 0.5;
  asked.display.exposure_ev = 8;
  const Frame frame = render(asked);
  EXPECT_GT(shown_at(frame, 80, 10), 0);
  EXPECT_EQ(shown_at(frame, 20, 45), 0);
}

// The resting frame of a stream is the still: the same passes, whatever was rendered before.
TEST_F(BloomTest, IsTheSameInAStreamsRestingFrameAndInAStill) {
  FrameRequest still = display_of(sun_alone());
  still.quality.samples = 4;
  const Frame whole = render(still);
  FrameRequest part = display_of(sun_alone());
  part.quality.samples = 1;
  Frame last;
  for (part.first_sample = 0; part.first_sample < 4; ++part.first_sample) last = renderer().render(part);
  renderer().forget(part.stream);
  EXPECT_EQ(last.display_rgba, whole.display_rgba);
}

class BloomExecutions : public OwnStackTest {};

TEST_F(BloomExecutions, GlowAlike) {
  std::vector<std::vector<std::uint8_t>> shown;
  for (const gpu::PassExecution execution : {gpu::PassExecution::compute, gpu::PassExecution::fragment}) {
    Stack own(execution);
    shown.push_back(own.renderer.render(display_of(sun_alone())).display_rgba);
  }
  for (std::size_t i = 0; i < shown[0].size(); ++i) ASSERT_NEAR(shown[0][i], shown[1][i], 1) << i;
}

}  // namespace
}  // namespace cloudscape::render
