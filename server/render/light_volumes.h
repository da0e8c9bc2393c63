// Volumes of light in clouds, on the grid of their densities and marched through those. Each is a pure function of the
// clouds and of a few more values, which are its key.
//
// They are baked in slices of a few milliseconds. A frame whose light may lag takes the last that is done of its
// clouds; others wait. Streams share them.
#pragma once
#include <array>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "render/cloud_densities.h"

namespace cloudscape::render {

class LightVolumes {
 public:
  struct Kind {
    std::string shader;
    gpu::Format format;
    const char* label;
    int across, layers;                          // points of a level
    int layers_per_slice, layers_per_low_slice;  // low: of a light whose way through the clouds is long
  };
  // The densities must outlive it.
  LightVolumes(gpu::ShaderLibrary& shaders, CloudDensities& densities, Kind kind);
  struct Key {
    vec4 light, lean;  // that of the shader's block, and of the clouds
    std::array<float, 2> medium{};
    bool operator==(const Key&) const = default;
  };
  // Bakes the next slice of what the frame needs; true when `volume` is there, or there are no clouds. Binds blocks of
  // its own.
  bool prepare(const CloudDensities::Wanted& wanted, const Key& key, std::shared_ptr<const gpu::Texture>& volume);
  void reload(gpu::ShaderLibrary& shaders);
  int slices() const { return slices_; }  // baked so far, the densities' not counted

 private:
  struct Volume {
    Key key;
    std::shared_ptr<gpu::Texture> texture;
    CloudBlock cloud;  // when it was begun
    int next_layer = 0;
    bool is_done() const { return next_layer >= texture->depth(); }
  };
  struct Clouds {
    std::shared_ptr<CloudDensities::Density> density;
    std::list<Volume> volumes;  // most recently asked first
    std::shared_ptr<const gpu::Texture> newest;
  };
  Clouds& clouds_of(const CloudDensities::Wanted& wanted);
  Volume& volume_of(Clouds& clouds, const CloudDensities::Wanted& wanted, const Key& key);
  void bake_slice(const CloudBlock& cloud, Clouds& clouds, Volume& volume);
  int layers_of_slice(const vec4& light) const;

  Kind kind_;
  CloudDensities& densities_;
  gpu::ShaderLibrary& shaders_;
  std::optional<gpu::VolumePass> pass_;  // once it is wanted
  gpu::UniformBlock<CloudBlock> cloud_block_;
  gpu::UniformBlock<SunBlock> block_;
  std::list<Clouds> clouds_;  // most recently asked first
  int slices_ = 0;
};

}  // namespace cloudscape::render
