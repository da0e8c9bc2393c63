#include "render/bloom_chain.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::render {
namespace {

using gpu::Format, gpu::Texture;

constexpr int coarsest_texels = 512;      // few enough for one texel to read them all
constexpr double least_deviation = 1.25;  // tuned, in texels: less is not smooth between them, more needs more taps

ImageSize divided(ImageSize size, int divisor) {
  return {(size.width + divisor - 1) / divisor, (size.height + divisor - 1) / divisor};
}

ImageSize finest_size(ImageSize size_px, int finest_rows) {
  const int divisor = static_cast<int>(std::lround(static_cast<double>(size_px.height) / finest_rows));
  return divided(size_px, std::max(1, divisor));
}

// Variance, in texels^2 of a level, of shrinking the picture to it (a box: 1/12) and of interpolating it back through
// the finer levels: each doubling has the weights 1/8 3/8 3/8 1/8 at -3/4 -1/4 1/4 3/4, and the last step is a tent
// (1/6). A box or a tent over n pixels has 1 - 1/n^2 of that. `finest_px`: pixels of the picture a texel of the finest
// level.
double filter_variance(int level, double finest_px) {
  const double finest = std::pow(0.25, level);  // area of a texel of the finest level
  const auto of_pixels = [](double side_px) { return 1 - 1 / (side_px * side_px); };
  return of_pixels(finest_px / std::sqrt(finest)) / 12 + 0.25 * (1 - finest) + finest * of_pixels(finest_px) / 6;
}

// A Gaussian that has this standard deviation (texels) together with the filters.
std::array<double, 8> kernel_of(double deviation, double filtered) {
  const double variance = std::max(0.01, deviation * deviation - filtered);
  std::array<double, 8> weights{};
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = std::exp(-0.5 * static_cast<double>(i * i) / variance);
    sum += (i == 0 ? 1 : 2) * weights[i];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

int taps_of(const std::array<double, 8>& kernel) {
  constexpr double negligible = 1e-5;
  int taps = 7;
  while (taps > 0 && kernel[static_cast<std::size_t>(taps)] < negligible) --taps;
  return taps;
}

// Texels of a level for each pixel of the picture.
double scale_of(int level_side, int side_px) { return static_cast<double>(level_side) / side_px; }

vec4 four(const std::array<double, 8>& values, std::size_t first) {
  return {values[first], values[first + 1], values[first + 2], values[first + 3]};
}

BloomBlock block_of(ImageSize size, bool wraps, const BloomBlur* blur) {
  BloomBlock block{};
  block.size = {size.width, size.height, wraps ? 1 : 0, blur ? blur->taps : 0};
  if (!blur) return block;
  block.gaussian = {blur->share, 0, 0, 0};
  block.horizontal_near = four(blur->horizontal, 0), block.horizontal_far = four(blur->horizontal, 4);
  block.vertical_near = four(blur->vertical, 0), block.vertical_far = four(blur->vertical, 4);
  return block;
}

Texture level_texture(ImageSize size, bool wraps, const char* label) {
  Texture texture(Format::rgba32f, size.width, size.height, label);
  texture.sample_with(gpu::Filter::linear, wraps ? gpu::Wrap::repeat : gpu::Wrap::clamp, gpu::Wrap::clamp);
  return texture;
}

}  // namespace

BloomPlan bloom_plan(ImageSize size_px, double radius, int finest_rows) {
  BloomPlan plan{{finest_size(size_px, finest_rows)}, {}};
  const auto next_level = [&] { plan.sizes.push_back(divided(plan.sizes.back(), 2)); };
  for (const GlowGaussian& gaussian : glow_gaussians) {
    const double deviation_px = gaussian.deviation * radius * size_px.height;
    // Its level: the coarsest on which it still has its least deviation, and coarser than that of the one before.
    if (!plan.blurs.empty()) next_level();
    while (deviation_px * scale_of(plan.sizes.back().height, size_px.height) >= 2 * least_deviation) next_level();
    const int level = static_cast<int>(plan.sizes.size()) - 1;
    const double filtered = filter_variance(level, static_cast<double>(size_px.height) / plan.sizes[0].height);
    const auto horizontal = kernel_of(deviation_px * scale_of(plan.sizes.back().width, size_px.width), filtered);
    const auto vertical = kernel_of(deviation_px * scale_of(plan.sizes.back().height, size_px.height), filtered);
    plan.blurs.push_back(
        {level, gaussian.share, horizontal, vertical, std::max(taps_of(horizontal), taps_of(vertical))});
  }
  while (static_cast<long>(plan.sizes.back().width) * plan.sizes.back().height > coarsest_texels) next_level();
  return plan;
}

BloomLevel::BloomLevel(ImageSize size, bool wraps, const BloomBlur* blur)
    : bright(Format::rgba32f, size.width, size.height, "bloom, bright"),
      glow(level_texture(size, wraps, "bloom, glow")),
      block("bloom") {
  if (blur) rows = Texture(Format::rgba32f, size.width, size.height, "bloom, rows");
  block.upload(block_of(size, wraps, blur));
}

BloomChain::BloomChain(ImageSize size_px, double glow_radius, bool wraps_across, int finest_rows)
    : radius(glow_radius),
      wraps(wraps_across),
      scale(Format::r32f, 1, 1, "bloom, scale"),
      black(Format::rgba32f, 1, 1, "bloom, nothing coarser") {
  black.clear();
  const BloomPlan plan = bloom_plan(size_px, radius, finest_rows);
  auto blur = plan.blurs.begin();
  for (int level = 0; level < static_cast<int>(plan.sizes.size()); ++level) {
    const bool blurred = blur != plan.blurs.end() && blur->level == level;
    levels.emplace_back(plan.sizes[static_cast<std::size_t>(level)], wraps, blurred ? &*blur++ : nullptr);
  }
}

std::size_t BloomChain::bytes() const {
  std::size_t sum = scale.bytes() + black.bytes();
  for (const BloomLevel& level : levels)
    sum += level.bright.bytes() + level.glow.bytes() + (level.rows ? level.rows->bytes() : 0);
  return sum;
}

}  // namespace cloudscape::render
