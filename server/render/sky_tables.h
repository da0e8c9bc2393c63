// Tables of the clear sky (Hillaire 2020), each kept for the few skies that are being looked at. What is computed anew
// when:
//   air      transmittance and multiple scattering: when the atmosphere or the ground's albedo changes
//   level    sky view and aerial perspective as seen from one of a ladder of altitudes: when the light moves in
//            elevation, or the camera crosses a rung
//   view     a blend of the two levels about the camera: when its altitude changes
//   lights   what lights the clouds and the ground: when the light moves
// Nothing at all when the camera turns or moves sideways.
#pragma once
#include <list>
#include <memory>
#include <string>

#include "gpu/pass.h"
#include "render/blocks.h"

namespace cloudscape::render {

// The last few values by their keys.
template <class T>
class Recent {
 public:
  explicit Recent(std::size_t most) : most_(most) {}
  template <class Make>
  std::shared_ptr<const T> get(const std::string& key, const Make& make) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (entry->first != key) continue;
      entries_.splice(entries_.begin(), entries_, entry);
      return entry->second;
    }
    entries_.emplace_front(key, std::make_shared<const T>(make()));
    if (entries_.size() > most_) entries_.pop_back();
    return entries_.front().second;
  }
  void clear() { entries_.clear(); }

 private:
  std::size_t most_;
  std::list<std::pair<std::string, std::shared_ptr<const T>>> entries_;  // most recently used first
};

// Rungs of the ladder of altitudes that skies are computed for: a quarter farther apart each, 62 m at the ground.
double level_altitude_m(int level);
int level_below(double altitude_m);
double blended_altitude_m(double altitude_m);  // the nearest sixteenth of a rung

// tuned: a flight that climbs blends the view anew at each sixteenth of a rung, which changes it by a thousandth.
enum class AltitudeOfView { exact, by_sixteenths };

class SkyTables {
 public:
  struct Air {
    gpu::Texture transmittance, multiple;
  };
  struct View {  // of a level, or blended
    gpu::Texture even, aerosol, aerial;
  };
  struct Lights {
    gpu::Texture light, cloud_sun;
  };
  struct Set {
    std::shared_ptr<const Air> air;
    std::shared_ptr<const View> view;
    std::shared_ptr<const Lights> lights;
  };
  SkyTables(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  // The tables for this frame; the frame and cloud blocks must be bound.
  Set get(const FrameBlock& frame, const CloudBlock& cloud, AltitudeOfView altitude = AltitudeOfView::exact);
  void reload(gpu::ShaderLibrary& shaders);
  int bakes() const { return bakes_; }  // tables of air, levels and lights computed so far; blends do not count

 private:
  Air make_air();
  View make_level(const Air& air, int level);
  View blend(const View& lower, const View& upper, double share);
  Lights make_lights(const Air& air);
  void set_block(double altitude_m, double share, bool first_order);

  gpu::ScreenPass transmittance_, multiple_, view_, view_blend_, rays_, light_, cloud_sun_;
  gpu::VolumePass aerial_, aerial_blend_;
  gpu::UniformBlock<SkyBlock> block_;
  Recent<Air> airs_;
  Recent<View> levels_, views_;
  Recent<Lights> lights_;
  int bakes_ = 0;
};

}  // namespace cloudscape::render
