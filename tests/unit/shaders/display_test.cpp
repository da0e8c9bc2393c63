// Tone curves and the sRGB transfer function against published examples and exact formulas.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::vec3;
enum Curve { agx, aces, reinhard, none };  // as core's ToneCurve
constexpr std::array curves{agx, aces, reinhard, none};

vec3 display(vec3 radiance, int curve, float exposure = 1) {
  return glsl::display_from_radiance(radiance, exposure, curve);
}
int code(float value) { return static_cast<int>(std::floor(255 * value + 0.5F)); }

// IEC 61966-2-1, the decoding half.
long double linear_from_srgb(long double s) {
  return s <= 0.04045L ? s / 12.92L : std::pow((s + 0.055L) / 1.055L, 2.4L);
}

TEST(Srgb, DecodesToWhatWasEncoded) {
  for (int i = 0; i <= 4096; ++i) {
    const float x = i / 4096.0F;
    EXPECT_NEAR(linear_from_srgb(glsl::srgb_from_linear(x)), x, 1e-6);
  }
}

TEST(Srgb, KeepsEveryEightBitCode) {
  for (int i = 0; i < 256; ++i) EXPECT_EQ(code(glsl::srgb_from_linear(linear_from_srgb(i / 255.0L))), i);
}

TEST(Srgb, IsLinearNearBlackAndJoinsThere) {
  EXPECT_FLOAT_EQ(glsl::srgb_from_linear(0.002), 0.02584);
  EXPECT_NEAR(glsl::srgb_from_linear(0.0031307), glsl::srgb_from_linear(0.0031309), 1e-5);
}

struct Example {
  Curve curve;
  std::array<int, 4> codes;  // of grey 0.18, 0.5, 1 and 4
};
const Example examples[] = {{none, {118, 188, 255, 255}},
                            {reinhard, {109, 156, 188, 231}},
                            {aces, {91, 165, 206, 245}},
                            {agx, {127, 173, 201, 238}}};

TEST(ToneCurves, MeetTheirExamples) {
  for (const Example& example : examples) {
    std::size_t i = 0;
    for (const float grey : {0.18F, 0.5F, 1.0F, 4.0F}) {
      const vec3 shown = display(vec3(grey), example.curve);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(code(shown[channel]), example.codes[i], 1) << example.curve << ' ' << grey << ' ' << channel;
      ++i;
    }
  }
}

TEST(ToneCurves, NeverFallAsLightGrows) {
  for (const Curve curve : curves) {
    float before = -1;
    for (int i = -200; i <= 200; ++i) {
      const float shown = display(vec3(std::exp2(i / 20.0F)), curve).y;
      EXPECT_GE(shown, before - 1e-6) << curve << ' ' << i;
      before = shown;
    }
    EXPECT_GT(before, 0.98) << curve;  // 1000 times white is white
    EXPECT_LT(code(display(vec3(0), curve).x), 2) << curve;
  }
}

TEST(ToneCurves, StayDisplayableForAnyColor) {
  Samples samples;
  for (const Curve curve : curves)
    for (int i = 0; i < 5000; ++i) {
      const vec3 logs = samples.in_box(vec3(-10), vec3(8));
      const vec3 shown = display(glm::exp(logs), curve);
      for (int channel = 0; channel < 3; ++channel) {
        ASSERT_GE(shown[channel], 0);
        ASSERT_LE(shown[channel], 1 + 1e-6);
      }
    }
}

TEST(ToneCurves, TakeExposureAsAFactorAndClampNegativeLight) {
  for (const Curve curve : curves) {
    EXPECT_EQ(display(vec3(0.1, 0.2, 0.3), curve, 4), display(vec3(0.4, 0.8, 1.2), curve));
    EXPECT_EQ(display(vec3(-1, -5, -0.1), curve), display(vec3(0), curve));
  }
}

// Luminance L becomes L / (1 + L), also for colours whose strongest channel has to be bent below 1.
TEST(Reinhard, MapsLuminanceAlone) {
  Samples samples;
  for (int i = 0; i < 5000; ++i) {
    const vec3 color = glm::exp(samples.in_box(vec3(-6), vec3(4)));
    const double luminance = 0.2126L * color.x + 0.7152L * color.y + 0.0722L * color.z;
    EXPECT_NEAR(glsl::luminance(glsl::tone_reinhard(color)), luminance / (1 + luminance), 2e-6);
  }
}

TEST(Reinhard, KeepsTheHueOfWhatFits) {
  const vec3 color(0.3, 0.2, 0.1), mapped = glsl::tone_reinhard(color);
  EXPECT_NEAR(mapped.x / mapped.y, 1.5, 1e-6);
  EXPECT_NEAR(mapped.y / mapped.z, 2, 1e-6);
}

}  // namespace
}  // namespace cloudscape
