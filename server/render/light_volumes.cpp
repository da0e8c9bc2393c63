#include "render/light_volumes.h"

#include <algorithm>

namespace cloudscape::render {
namespace {

constexpr std::size_t most_clouds = 4, most_volumes = 6;  // tuned: what the streams of a server look at together

}  // namespace

LightVolumes::LightVolumes(gpu::ShaderLibrary& shaders, CloudDensities& densities, Kind kind)
    : kind_(std::move(kind)),
      densities_(densities),
      shaders_(shaders),
      cloud_block_("cloud in the light"),
      block_("light in clouds") {}

LightVolumes::Clouds& LightVolumes::clouds_of(const CloudDensities::Wanted& wanted) {
  const auto density = densities_.of(wanted);
  const auto found = std::ranges::find(clouds_, density, &Clouds::density);
  if (found != clouds_.end()) {
    clouds_.splice(clouds_.begin(), clouds_, found);
    return clouds_.front();
  }
  clouds_.push_front({density, {}, nullptr});
  if (clouds_.size() > most_clouds) clouds_.pop_back();
  return clouds_.front();
}

// Light that may lag is baked one key after the other, each to its end.
LightVolumes::Volume& LightVolumes::volume_of(Clouds& clouds, const CloudDensities::Wanted& wanted, const Key& key) {
  std::list<Volume>& volumes = clouds.volumes;
  auto found = std::ranges::find(volumes, key, &Volume::key);
  if (found == volumes.end() && wanted.request.light_may_lag)
    found = std::ranges::find_if(volumes, [](const Volume& each) { return !each.is_done(); });
  if (found == volumes.end()) {
    auto texture = std::make_shared<gpu::Texture>(
        cloud_grid_texture(wanted.cloud, kind_.format, {kind_.across, kind_.layers}, kind_.label));
    volumes.push_front({key, std::move(texture), wanted.cloud});
    if (volumes.size() > most_volumes) volumes.pop_back();
  } else {
    volumes.splice(volumes.begin(), volumes, found);
  }
  return volumes.front();
}

int LightVolumes::layers_of_slice(const vec4& light) const {
  constexpr float low = 0.35F;  // tuned: sine of 20 degrees
  return light.z < low ? kind_.layers_per_low_slice : kind_.layers_per_slice;
}

void LightVolumes::bake_slice(const CloudBlock& cloud, Clouds& clouds, Volume& volume) {
  if (!clouds.density->is_done()) return densities_.bake_slice(cloud, *clouds.density);
  cloud_block_.upload(volume.cloud), cloud_block_.bind();
  block_.upload(sun_block(volume.cloud, volume.key.light)), block_.bind();
  const gpu::Binding density{0, &clouds.density->cells};
  if (!pass_) pass_.emplace(shaders_, kind_.shader);
  const int end = volume.next_layer + layers_of_slice(volume.key.light);
  pass_->run(*volume.texture, volume.next_layer, end, std::span(&density, 1));
  volume.next_layer = end;
  ++slices_;
  if (volume.is_done()) clouds.newest = volume.texture;
}

bool LightVolumes::prepare(const CloudDensities::Wanted& wanted, const Key& key,
                           std::shared_ptr<const gpu::Texture>& volume) {
  if (volume || !has_cloud_grid(wanted.cloud, *wanted.request.cloudscape)) return true;
  Clouds& clouds = clouds_of(wanted);
  Volume& baked = volume_of(clouds, wanted, key);
  const bool rests = wanted.rests && clouds.newest;
  if (!rests && !baked.is_done()) bake_slice(wanted.cloud, clouds, baked);
  if (baked.is_done())
    volume = baked.texture;
  else if (wanted.request.light_may_lag)
    volume = clouds.newest;
  return volume != nullptr;
}

void LightVolumes::reload(gpu::ShaderLibrary& shaders) {
  if (pass_) pass_ = gpu::VolumePass(shaders, kind_.shader);
  clouds_.clear();
}

}  // namespace cloudscape::render
