#include "render/sun_depth.h"

#include <algorithm>

#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using gpu::Filter, gpu::Format, gpu::Texture, gpu::Wrap;

constexpr std::size_t most_clouds = 4, most_lit = 6;  // tuned: what the streams of a server look at together; 2 MB each

bool casts_shadows(const CloudBlock& cloud, const Cloudscape& sky) {
  return is_textured(sky.volume.kind) && cloud.medium.x > 0 && cloud.march.w > cloud.march.z;
}

int levels_of(const CloudBlock& cloud) { return static_cast<int>(cloud.in_scatter_scale.w); }

std::vector<vec4> clouds_key(const CloudBlock& cloud) {
  return {cloud.layer,
          cloud.weights,
          cloud.erosion,
          vec4(cloud.shape.y, cloud.tile.x, cloud.tile.y, cloud.volume.y),
          vec4(cloud.march.z, cloud.march.w, cloud.box_low.w, cloud.in_scatter_scale.w),
          vec4(cloud.in_scatter_levels.x, cloud.in_scatter_levels.y, 0, 0)};
}

Texture volume_of(const CloudBlock& cloud, const char* label) {
  Texture texture(Format::r32f, SunDepths::across, SunDepths::across, SunDepths::layers * levels_of(cloud), label);
  const Wrap across = cloud.box_low.w > 0 ? Wrap::repeat : Wrap::clamp;
  texture.sample_with(Filter::linear, across, across, Wrap::clamp);
  return texture;
}

SunBlock sun_block(const CloudBlock& cloud, const vec4& light) {
  const float low = (cloud.march.z - cloud.layer.x) * cloud.layer.z;
  const float high = (cloud.march.w - cloud.layer.x) * cloud.layer.z;
  const float step = cloud.in_scatter_levels.y > 0 ? 1 / cloud.in_scatter_levels.y : 0;
  return {light, vec4(cloud.in_scatter_levels.x, step, low, high),
          ivec4(SunDepths::across, SunDepths::across, SunDepths::layers, levels_of(cloud))};
}

// An upright, flat tile.
CloudBlock unmoved(CloudBlock cloud) {
  cloud.tile.z = cloud.tile.w = 0;
  cloud.lean = vec4(0);
  cloud.volume.y = 0;
  return cloud;
}

bool is_done(int next_layer, const Texture& volume) { return next_layer >= volume.depth(); }

}  // namespace

SunDepths::SunDepths(gpu::ShaderLibrary& shaders)
    : density_(shaders, "render/sun_density.comp"),
      depth_(shaders, "render/sun_depth.comp"),
      cloud_block_("cloud in the light"),
      block_("sun") {}

SunDepths::Clouds& SunDepths::clouds_of(const Wanted& wanted) {
  const std::vector<vec4> key = clouds_key(wanted.cloud);
  const auto found = std::ranges::find_if(
      clouds_, [&](const Clouds& each) { return each.baked.lock() == wanted.baked && each.key == key; });
  if (found != clouds_.end()) {
    clouds_.splice(clouds_.begin(), clouds_, found);
    return clouds_.front();
  }
  clouds_.push_front({wanted.baked, key, volume_of(wanted.cloud, "density towards the light"), 0, {}, nullptr});
  if (clouds_.size() > most_clouds) clouds_.pop_back();
  return clouds_.front();
}

// Light that may lag is baked one direction after the other, each to its end.
SunDepths::Lit& SunDepths::lit_of(Clouds& clouds, const Wanted& wanted) {
  const Light light{vec4(direction_of_light(*wanted.request.cloudscape), 0), wanted.cloud.lean};
  auto found = std::ranges::find(clouds.lit, light, &Lit::light);
  if (found == clouds.lit.end() && wanted.request.light_may_lag)
    found = std::ranges::find_if(clouds.lit, [](const Lit& each) { return !is_done(each.next_layer, *each.depth); });
  if (found == clouds.lit.end()) {
    clouds.lit.push_front({light, std::make_shared<Texture>(volume_of(wanted.cloud, "depth towards the light")), 0});
    if (clouds.lit.size() > most_lit) clouds.lit.pop_back();
  } else {
    clouds.lit.splice(clouds.lit.begin(), clouds.lit, found);
  }
  return clouds.lit.front();
}

void SunDepths::bake_slice(const CloudBlock& cloud, Clouds& clouds, Lit& lit) {
  const bool density = !is_done(clouds.next_layer, clouds.density);
  CloudBlock block = density ? unmoved(cloud) : cloud;
  if (!density) block.lean = lit.light.lean;
  cloud_block_.upload(block), cloud_block_.bind();
  block_.upload(sun_block(cloud, lit.light.direction)), block_.bind();
  int& layer = density ? clouds.next_layer : lit.next_layer;
  const gpu::Binding texture{0, density ? &clouds.baked.lock()->shape() : &clouds.density};
  (density ? density_ : depth_)
      .run(density ? clouds.density : *lit.depth, layer, layer + layers_per_slice, std::span(&texture, 1));
  layer += layers_per_slice;
  ++slices_;
  if (is_done(lit.next_layer, *lit.depth)) clouds.newest = lit.depth;
}

bool SunDepths::prepare(const Wanted& wanted, std::shared_ptr<const Texture>& depth) {
  if (depth || !casts_shadows(wanted.cloud, *wanted.request.cloudscape)) return true;
  Clouds& clouds = clouds_of(wanted);
  Lit& lit = lit_of(clouds, wanted);
  const bool rests = wanted.rests && clouds.newest;
  if (!rests && !is_done(lit.next_layer, *lit.depth)) bake_slice(wanted.cloud, clouds, lit);
  if (is_done(lit.next_layer, *lit.depth))
    depth = lit.depth;
  else if (wanted.request.light_may_lag)
    depth = clouds.newest;
  return depth != nullptr;
}

void SunDepths::reload(gpu::ShaderLibrary& shaders) {
  density_ = gpu::VolumePass(shaders, "render/sun_density.comp");
  depth_ = gpu::VolumePass(shaders, "render/sun_depth.comp");
  clouds_.clear();
}

}  // namespace cloudscape::render
