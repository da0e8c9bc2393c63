// Tables of the clear sky (Hillaire 2020), each kept for the few skies that are being looked at. What is computed anew
// when:
//   air      transmittance and multiple scattering: when the atmosphere or the ground's albedo changes
//   level    sky view and aerial perspective as seen from one of a ladder of altitudes: when the light moves in
//            elevation, or the camera crosses a rung
//   view     a blend of the two levels about the camera: when its altitude changes
//   lights   what lights the clouds and the ground: when the light moves
// Nothing at all when the camera turns or moves sideways.
#pragma once
#include <algorithm>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "core/frame.h"
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
    if (auto found = find(key)) return found;
    entries_.emplace_front(key, std::make_shared<const T>(make()));
    if (entries_.size() > most_) entries_.pop_back();
    return entries_.front().second;
  }
  std::shared_ptr<const T> find(const std::string& key) {  // nullptr: it is not there
    return first_of([&](const std::string& each) { return each == key; });
  }
  // The one asked for last whose key begins and ends so.
  std::shared_ptr<const T> newest(const std::string& begin, const std::string& end) {
    return first_of([&](const std::string& each) { return each.starts_with(begin) && each.ends_with(end); });
  }
  void clear() { entries_.clear(); }

 private:
  template <class Wanted>
  std::shared_ptr<const T> first_of(const Wanted& wanted) {
    const auto found = std::ranges::find_if(entries_, [&](const auto& entry) { return wanted(entry.first); });
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return found->second;
  }
  std::size_t most_;
  std::list<std::pair<std::string, std::shared_ptr<const T>>> entries_;  // most recently used first
};

// Rungs of the ladder of altitudes that skies are computed for: a quarter farther apart each, 62 m at the ground.
double level_altitude_m(int level);
int level_below(double altitude_m);
double blended_altitude_m(double altitude_m);  // the nearest sixteenth of a rung
double share_of_upper(double altitude_m);      // of the two rungs about it

// tuned: a flight that climbs blends the view anew at each sixteenth of a rung, which changes it by a thousandth.
enum class AltitudeOfView { exact, by_sixteenths };
// What is baked in a new light: all; the lights, and one of the view's tables beside the others as they were just
// before; nothing yet.
enum class SkyLag { none, but_for_one, all };

// `rests`: it is another one's turn.
inline SkyLag sky_lag(const FrameRequest& request, bool rests) {
  if (!request.light_may_lag) return SkyLag::none;
  return rests ? SkyLag::all : SkyLag::but_for_one;
}

class SkyTables {
 public:
  struct Air {
    gpu::Texture transmittance, multiple;
  };
  struct View {  // between two levels
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
  Set get(const FrameBlock& frame, const CloudBlock& cloud, AltitudeOfView altitude = AltitudeOfView::exact,
          SkyLag lag = SkyLag::none);
  void reload(gpu::ShaderLibrary& shaders);
  int bakes() const { return bakes_; }  // tables of air, levels and lights computed so far; blends do not count

 private:
  struct Dome {  // the sky of a level
    gpu::Texture even, aerosol;
    int made = 0;  // after so many other tables
  };
  struct Aerial {  // the air before what a level sees
    gpu::Texture air;
    int made = 0;
  };
  struct Levels {
    std::shared_ptr<const Dome> lower_dome, upper_dome;
    std::shared_ptr<const Aerial> lower_air, upper_air;
  };
  std::shared_ptr<const Lights> lights_of(const FrameBlock& frame, const CloudBlock& cloud, const Air& air, SkyLag lag);
  std::shared_ptr<const View> view_of(const FrameBlock& frame, const Air& air, double altitude_m, SkyLag lag);
  std::optional<Levels> lagging_levels(const FrameBlock& frame, const Air& air, int level, SkyLag lag);
  std::shared_ptr<const Dome> dome_of(const std::string& sky, const Air& air, int level);
  std::shared_ptr<const Aerial> aerial_of(const std::string& sky, const Air& air, int level);
  Air make_air();
  Dome make_dome(const Air& air, int level);
  Aerial make_aerial(const Air& air, int level);
  std::shared_ptr<const View> lagging_view(const Levels& levels, double share);
  View blend(const Levels& levels, double share);
  Lights make_lights(const Air& air);
  void set_block(double altitude_m, double share, bool first_order);

  gpu::ScreenPass transmittance_, multiple_, view_, view_blend_, rays_, light_, cloud_sun_;
  gpu::VolumePass aerial_, aerial_blend_;
  gpu::UniformBlock<SkyBlock> block_;
  Recent<Air> airs_;
  Recent<Dome> domes_;
  Recent<Aerial> aerials_;
  Recent<View> views_, lagging_views_;
  Recent<Lights> lights_;
  int bakes_ = 0;
};

}  // namespace cloudscape::render
