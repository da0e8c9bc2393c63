// Camera, lens and display settings: what a picture is taken with.
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "core/cloudscape_march.h"
#include "core/fields.h"

namespace cloudscape {

// World frame. Azimuth is clockwise from north, elevation above the horizon; positive roll turns the camera clockwise.
struct CameraPose {
  glm::dvec3 position_m{0.0, 0.0, 2.0};
  double azimuth_deg = 0.0;
  double elevation_deg = 10.0;
  double roll_deg = 0.0;
  bool operator==(const CameraPose&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, Limits{-1e7, 1e7}, "East, north and altitude of the camera, m.");
    visit("azimuth_deg", self.azimuth_deg, Limits{-36000, 36000}, "Where it looks, clockwise from north, degrees.");
    visit("elevation_deg", self.elevation_deg, Limits{-90, 90}, "Where it looks, above the horizon, degrees.");
    visit("roll_deg", self.roll_deg, Limits{-360, 360}, "Turn about the line of sight, clockwise, degrees.");
  }
};

enum class LensKind { perspective, orthographic, panorama, fisheye };
template <>
struct EnumNames<LensKind> {
  static constexpr std::array<std::string_view, 4> names{"perspective", "orthographic", "panorama", "fisheye"};
};

// perspective: vertical_fov_deg between the middles of the top and bottom edges. orthographic: parallel rays, width_m
// across the picture. panorama: equirectangular, 360 by 180 degrees. fisheye: equidistant, 180 degrees across the
// smaller side.
struct Lens {
  LensKind kind = LensKind::perspective;
  double vertical_fov_deg = 50.0;
  double width_m = 10000.0;
  bool operator==(const Lens&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("kind", self.kind, Limits{}, "Projection.");
    visit("vertical_fov_deg", self.vertical_fov_deg, Limits{1, 170},
          "Vertical field of view of a perspective lens, degrees.");
    visit("width_m", self.width_m, Limits{1, 1e6}, "Width of an orthographic picture, m.");
  }
};

enum class ToneCurve { agx, aces, reinhard, none };
template <>
struct EnumNames<ToneCurve> {
  static constexpr std::array<std::string_view, 4> names{"agx", "aces", "reinhard", "none"};
};

struct Display {
  double exposure_ev = 1.5;  // a sunlit cloud top, about 0.5 in solar units, comes out nearly white
  ToneCurve tone_curve = ToneCurve::aces;
  bool dither = true;
  // tuned: five times a sunlit cloud top, so that in a clear sky only the sun's disc and what lies right about it
  // glows; as wide as a bright sun dazzles, and as strong as leaves the clouds beside it visible.
  double bloom_strength = 0.06;
  double bloom_threshold = 8.0;
  double bloom_radius = 0.08;
  bool operator==(const Display&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("exposure_ev", self.exposure_ev, Limits{-20, 20},
          "Radiance is multiplied by 2 to this power before the tone curve.");
    visit("tone_curve", self.tone_curve, Limits{},
          "How radiance becomes display values; reinhard is L / (1 + L) on luminance.");
    visit("dither", self.dither, Limits{}, "Noise of one display step before rounding to 8 bits; hides banding.");
    visit("bloom_strength", self.bloom_strength, Limits{0, 1},
          "Share of the light above bloom_threshold that glows about its place (Olajos 2.7); 0: none.");
    visit("bloom_threshold", self.bloom_threshold, Limits{0, 1e6},
          "Luminance above which light glows, as exposed: 1 is a white that is just displayed as such.");
    visit("bloom_radius", self.bloom_radius, Limits{0.02, 0.5},
          "Standard deviation of the glow as a share of the picture's height.");
  }
};

struct View {
  CameraPose pose;
  Lens lens;
  Display display;
  March march;
  bool operator==(const View&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("pose", self.pose, Limits{}, "Camera position and orientation.");
    visit("lens", self.lens, Limits{}, "Projection and field of view.");
    visit("display", self.display, Limits{}, "Exposure and tone curve.");
    visit("march", self.march, Limits{}, "Techniques of the ray march (Olajos 2.4).");
  }
};

}  // namespace cloudscape
