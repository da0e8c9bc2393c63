#include "render/targets.h"

#include <algorithm>

namespace cloudscape::render {
namespace {

using gpu::Format, gpu::Texture;

constexpr std::size_t most_free = 4;  // tuned: sizes that alternate without being made anew each time

int divided(int length, int divisor) { return (length + divisor - 1) / divisor; }

std::unique_ptr<Targets> make_targets(ImageSize size, int divisor, bool float32) {
  const Format hdr = float32 ? Format::rgba32f : Format::rgba16f;
  const int march_width = divided(size.width, divisor), march_height = divided(size.height, divisor);
  auto targets = std::make_unique<Targets>(
      Targets{size, divisor, float32, Texture(hdr, size.width, size.height, "scene radiance"),
              Texture(Format::r32f, size.width, size.height, "scene depth"),
              Texture(hdr, march_width, march_height, "march radiance"),
              Texture(Format::rg32f, march_width, march_height, "march depth"),
              Texture(Format::rgba8, size.width, size.height, "display"), make_accumulation(size)});
  targets->march_radiance.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return targets;
}

}  // namespace

Accumulation make_accumulation(ImageSize size) {
  return {Texture(Format::rgba32f, size.width, size.height, "accumulated radiance"),
          Texture(Format::r32f, size.width, size.height, "accumulated depth")};
}

std::unique_ptr<Targets> TargetPool::acquire(ImageSize size, int march_divisor, bool float32) {
  const auto fits = [&](const std::unique_ptr<Targets>& targets) {
    return targets->size == size && targets->march_divisor == march_divisor && targets->float32 == float32;
  };
  const auto found = std::find_if(free_.begin(), free_.end(), fits);
  if (found == free_.end()) return make_targets(size, march_divisor, float32);
  auto targets = std::move(*found);
  free_.erase(found);
  return targets;
}

void TargetPool::release(std::unique_ptr<Targets> targets) {
  free_.push_front(std::move(targets));
  if (free_.size() > most_free) free_.pop_back();
}

}  // namespace cloudscape::render
