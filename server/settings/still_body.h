// The parts of a still request as described values; the JSON body has this form, a query names the same members flatly.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/clock.h"
#include "core/cloudscape.h"
#include "core/frame.h"

namespace cloudscape::settings {

// Of a picture's side, whatever the server's own limit: the stream's header has 16 bits.
constexpr Limits side_px_limits{1, 65535};

struct StillCamera {
  CameraPose pose;
  Lens lens;

  static void fields(auto& self, auto&& visit) {
    CameraPose::fields(self.pose, visit);
    visit("lens", self.lens, Limits{}, "Projection and field of view.");
  }
};

struct StillImage {
  ImageSize size_px;
  Quality quality = Quality::standard;
  std::optional<int> samples;
  Tracing tracing;
  double time_s = 0;
  Display display;
  Encoding encoding;

  static void fields(auto& self, auto&& visit) {
    visit("width", self.size_px.width, side_px_limits, "Width of the picture, pixels.");
    visit("height", self.size_px.height, side_px_limits, "Height of the picture, pixels.");
    visit("quality", self.quality, Limits{}, "How much work the picture is worth.");
    visit("samples", self.samples, Limits{1, 65536},
          "Jittered pictures that are averaged, or paths of a pixel; by default the quality's. With time_budget_s or "
          "noise_target the most, by default 4096.");
    Tracing::fields(self.tracing, visit);
    visit("time_s", self.time_s, time_s_limits, "Time that the wind has moved the clouds for, s.");
    Display::fields(self.display, visit);
    visit("format", self.encoding.format, Limits{},
          "jpeg and png: 8 bit display values. exr: linear radiance, alpha and depth.");
    visit("jpeg_quality", self.encoding.jpeg_quality, Limits{1, 100}, "Quality of a JPEG picture.");
    visit("exr_type", self.encoding.exr_type, Limits{}, "Size of an OpenEXR picture's numbers: 16 or 32 bits.");
  }
};

struct StillSun {
  Sun sun;

  static void fields(auto& self, auto&& visit) {
    each_angle(self.sun, visit);
    visit("place", self.sun.place, Limits{}, "Place and time that the sun stands by, instead of by angles.");
  }
  // The sun's two angles as the sun describes them.
  static void each_angle(auto& sun, auto&& visit) {
    Sun::fields(sun, [&](std::string_view name, auto& member, const Limits& limits, std::string_view meaning) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, double>)
        if (&member == &sun.azimuth_deg || &member == &sun.elevation_deg) visit(name, member, limits, meaning);
    });
  }
};

// How the medium interacts with light, where a request changes it.
struct StillMedium {
  Phase phase;
  LightModel light_model;

  static void fields(auto& self, auto&& visit) {
    visit("phase", self.phase, Limits{}, "Phase function and its parameters.");
    visit("light_model", self.light_model, Limits{}, "Sunlight inside the cloud.");
  }
};

// What people call a still; it changes nothing of the picture.
struct StillHeading {
  std::string title, description;

  static void fields(auto& self, auto&& visit) {
    visit("title", self.title, Limits{0, 80}, "Short name for people.");
    visit("description", self.description, Limits{0, 500}, "One sentence about what it shows.");
  }
};

// Everything but the cloudscape.
struct StillBody {
  StillCamera camera;
  StillImage image;
  StillSun sun;
  March march;
  StillMedium medium;

  static void fields(auto& self, auto&& visit) {
    visit("camera", self.camera, Limits{}, "Pose and lens; by default the cloudscape's view.");
    visit("image", self.image, Limits{}, "Size, quality and format.");
    visit("sun", self.sun, Limits{}, "Where the sun stands; by default as the cloudscape says.");
    visit("march", self.march, Limits{}, "Techniques of the ray march; by default as the cloudscape's view says.");
    visit("medium", self.medium, Limits{}, "Phase and light model; by default as the cloudscape says.");
  }
};

}  // namespace cloudscape::settings
