#include "render/targets.h"

#include <algorithm>

namespace cloudscape::render {
namespace {

using gpu::Format, gpu::Texture;

int divided(int length, int divisor) { return (length + divisor - 1) / divisor; }

Texture march_target(Format format, int width, int height, const char* label) {
  Texture texture(format, width, height, label);
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return texture;
}

constexpr int tile_px = 64;  // llvmpipe's TILE_SIZE

// Where pixels begin of which the first and the last tile have as many.
int tile_origin(int length) {
  const int whole_tiles = std::max(0, divided(length - 2 * tile_px, tile_px));
  return (tile_px - (length - whole_tiles * tile_px) / 2) % tile_px;
}

glm::ivec2 march_origin(ImageSize size, RayPlaces places) {
  return places == RayPlaces::first ? glm::ivec2(0) : glm::ivec2(tile_origin(size.width), tile_origin(size.height));
}

std::unique_ptr<Targets> make_targets(ImageSize size, int divisor, bool float32, bool smooth, RayPlaces places) {
  const Format hdr = float32 ? Format::rgba32f : Format::rgba16f;
  const ImageSize march{divided(size.width, divisor), divided(size.height, divisor)};
  const glm::ivec2 origin = march_origin(march, places);
  const int width = origin.x + march.width, height = origin.y + march.height;
  auto targets = std::make_unique<Targets>();
  targets->size = size, targets->march_size = march, targets->march_origin = origin;
  targets->march_divisor = divisor, targets->float32 = float32, targets->smooth = smooth;
  targets->scene_radiance = Texture(hdr, origin.x + size.width, origin.y + size.height, "scene radiance");
  targets->scene_depth = Texture(Format::r32f, origin.x + size.width, origin.y + size.height, "scene depth");
  targets->march_radiance = march_target(hdr, width, height, "march radiance");
  targets->march_depth = Texture(Format::rg32f, width, height, "march depth");
  if (smooth) {
    targets->smooth_radiance = march_target(hdr, width, height, "smooth radiance");
    targets->smooth_depth = Texture(Format::rg32f, width, height, "smooth depth");
  }
  targets->display = Texture(Format::rgba8, size.width, size.height, "display");
  targets->scratch = make_accumulation(size);
  targets->scratch.radiance.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return targets;
}

}  // namespace

gpu::Format kept_format(const gpu::Context& context) {
  return context.device().software ? Format::rgba32f : Format::rgba16f;
}

Accumulation make_accumulation(ImageSize size) {
  return {Texture(Format::rgba32f, size.width, size.height, "accumulated radiance"),
          Texture(Format::r32f, size.width, size.height, "accumulated depth")};
}

void prepare_bloom(Targets& targets, const FrameRequest& request) {
  const double radius = request.display.bloom_radius;
  const bool wraps = request.lens.kind == LensKind::panorama;
  if (request.display.bloom_strength <= 0)
    targets.bloom.reset();
  else if (!targets.bloom || !targets.bloom->fits(radius, wraps))
    targets.bloom = std::make_unique<BloomChain>(targets.size, radius, wraps);
}

std::unique_ptr<Targets> TargetPool::acquire(ImageSize size, const RenderQuality& quality, RayPlaces places) {
  const bool smooth = quality.smooth && !quality.float32;
  const auto fits = [&](const std::unique_ptr<Targets>& targets) {
    return targets->size == size && targets->march_origin == march_origin(targets->march_size, places) &&
           targets->march_divisor == quality.march_divisor && targets->float32 == quality.float32 &&
           targets->smooth == smooth;
  };
  const auto found = std::find_if(free_.begin(), free_.end(), fits);
  if (found == free_.end()) return make_targets(size, quality.march_divisor, quality.float32, smooth, places);
  auto targets = std::move(*found);
  free_.erase(found);
  return targets;
}

void TargetPool::release(std::unique_ptr<Targets> targets) {
  free_.push_front(std::move(targets));
  if (free_.size() > most_free) free_.pop_back();
}

}  // namespace cloudscape::render
