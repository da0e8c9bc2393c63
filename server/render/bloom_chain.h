// The levels of the bloom (Olajos 2.7): ever coarser pictures of what glows, and the Gaussians that they are blurred
// with.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/frame.h"
#include "gpu/texture.h"
#include "render/blocks.h"

namespace cloudscape::render {

// The glow is a sum of Gaussians whose common standard deviation is the radius: a sharp core and a wide skirt, as light
// scattered in an eye or a lens has them (Spencer et al. 1995, Physically-Based Glare Effects).
struct GlowGaussian {
  double deviation;  // standard deviation, in radii
  double share;      // of the light
};
// tuned: a core that is seen as the source's own brilliance, a skirt that is felt as haze; more core looks like a ball,
// less like a smear. The last deviation follows: 0.2 * 0.2^2 + 0.4 * 0.6^2 + 0.4 * d^2 = 1.
constexpr std::array<GlowGaussian, 3> glow_gaussians{{{0.2, 0.2}, {0.6, 0.4}, {1.456022, 0.4}}};

// What a level is blurred with. A kernel has `taps` texels on each side of its middle and the sum 1.
struct BloomBlur {
  int level;
  double share;
  std::array<double, 8> horizontal, vertical;
  int taps;
};

struct BloomPlan {
  std::vector<ImageSize> sizes;  // of the levels, finest first
  std::vector<BloomBlur> blurs;  // ascending levels, one at most for each
};
// tuned: rows of the finest level. In a still the core of the default glow is three texels wide, and more rows cost
// more; in a moving picture a third of them do.
constexpr int bloom_rows = 180, moving_bloom_rows = 60;
// `radius`: of the glow, as a share of the picture's height. The finest level has about as many rows whatever the
// picture's size: the glow looks and costs the same at each.
BloomPlan bloom_plan(ImageSize size_px, double radius, int finest_rows = bloom_rows);

struct BloomLevel {
  BloomLevel(ImageSize size, bool wraps, const BloomBlur* blur);
  gpu::Texture bright, glow;
  std::optional<gpu::Texture> rows;  // blurred along the rows; where the level has a Gaussian
  gpu::UniformBlock<BloomBlock> block;
};

struct BloomChain {
  BloomChain(ImageSize size_px, double radius, bool wraps, int finest_rows = bloom_rows);
  bool fits(double wanted_radius, bool wanted_wraps) const { return radius == wanted_radius && wraps == wanted_wraps; }
  std::size_t bytes() const;

  double radius;
  bool wraps;  // left and right of the picture meet
  std::vector<BloomLevel> levels;
  gpu::Texture scale, black;  // one texel each
};

}  // namespace cloudscape::render
