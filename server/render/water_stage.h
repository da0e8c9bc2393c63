// The water of a frame: the sky above it, and the clouds that it reflects, as a small panorama of them.
//
// The panorama is taken from points of a lattice that drifts with the clouds, so that neither the wind nor a small move
// of the camera makes a new one, and a picture stays a function of its request. Streams of one document share it.
#pragma once
#include <list>
#include <memory>

#include "core/frame.h"
#include "gpu/pass.h"
#include "render/passes.h"

namespace cloudscape::render {

double mean_square_slope(double wind_m_per_s);  // Cox and Munk 1954; a mirror without wind
double longest_wave_m(double wind_m_per_s);     // of those that the wind raises

inline bool has_water(const Cloudscape& sky) { return sky.ground.water.level_m.has_value(); }

// Clouds that water reflects.
struct CloudPanorama {
  gpu::Texture clouds;  // radiance, transmittance; the upper half of a panorama with north in its middle; with levels
  glm::dvec2 eye_m;     // where it was taken, less the clouds' drift
  double altitude_m;    // of the clouds above the water, about
};

// What a frame holds on to while it is rendered; empty without water.
struct WaterView {
  std::optional<SkyTables::Set> sky;  // above the water
  std::shared_ptr<const CloudPanorama> panorama;
};

class WaterStage {
 public:
  WaterStage(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  // What the march of a frame's clouds takes; without land.
  struct Scene {
    const FrameRequest& request;
    const CloudBlock& cloud;  // of the request
    const Passes::Medium& medium;
    const std::shared_ptr<const InScatterVolume>& in_scatter;  // of the medium
    const std::shared_ptr<const gpu::Texture>& sun_depth;      // the same
    const Passes& passes;
    SkyTables& sky;
    bool sky_rests = false, clouds_rest = false;  // takes what is nearly it, if there is something, and renders nothing
  };
  // Renders the next slice of what the frame needs; true when all is there, or for a frame whose light may lag
  // something that is nearly it. Binds blocks of its own.
  bool prepare(const Scene& scene, WaterView& view);
  // Uploads and binds the block; the textures are for the scene pass.
  std::vector<gpu::Binding> bind(const FrameRequest& request, const WaterView& view);
  void reload(gpu::ShaderLibrary& shaders);
  int panoramas() const { return panoramas_made_; }  // begun so far

 private:
  struct Entry {
    std::shared_ptr<const Cloudscape> cloudscape;
    March march;
    std::weak_ptr<const InScatterVolume> in_scatter;
    std::weak_ptr<const gpu::Texture> sun_depth;
    std::shared_ptr<CloudPanorama> panorama;
    std::unique_ptr<Targets> targets;  // until it is done
    int next_row = 0;
  };
  Entry& entry_of(const Scene& scene);
  void drop_oldest();
  void render_slice(const Scene& scene, const SkyTables::Set& sky, Entry& entry);
  static bool is_of_clouds(const Entry& entry, const Cloudscape& sky);
  std::shared_ptr<const CloudPanorama> newest_like(const Entry& entry) const;

  gpu::ScreenPass gather_;
  gpu::UniformBlock<FrameBlock> frame_block_;
  gpu::UniformBlock<CloudBlock> cloud_block_;
  gpu::UniformBlock<WaterBlock> block_;
  std::list<Entry> entries_;  // most recently asked first
  int panoramas_made_ = 0;
};

}  // namespace cloudscape::render
