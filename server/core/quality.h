// How much work a picture is worth. Every number is a trade of time against noise or missed detail.
#pragma once
#include <array>
#include <string_view>

#include "core/fields.h"

namespace cloudscape {

enum class Quality { draft, interactive, standard, high, finest, reference };
template <>
struct EnumNames<Quality> {
  static constexpr std::array<std::string_view, 6> names{"draft", "interactive", "standard",
                                                         "high",  "finest",      "reference"};
};

// march: along each ray, with a light model. path_tracing: by random paths of light, without bias.
enum class Technique { march, path_tracing };

struct RenderQuality {
  int max_steps = 160;        // of one view ray
  double step_m = 60.0;       // first step; the march never steps finer
  double step_growth = 0.02;  // a step is at least this share of the distance to the camera
  int light_steps = 6;        // towards the sun, each longer than the one before
  int march_divisor = 1;      // clouds are marched at 1/n of the width and height
  int samples = 1;            // jittered pictures that are averaged
  bool float32 = false;       // 32 bit HDR targets instead of 16
  bool smooth = false;        // a 3x3 mean instead of samples; for 16 bit targets
  Technique technique = Technique::march;
  // Of moving pictures, which continue their stream's last one; a picture that nothing was kept for begins with what
  // it marches itself. Both are for perspective lenses.
  int reuse = 1;               // one in so many kept pixels is marched, the others come from the last picture: 1, 4, 16
  int resolution_divisor = 1;  // the picture is kept at 1/n of the width and height, and enlarged as it is shown
  bool operator==(const RenderQuality&) const = default;
};

// tuned: draft answers at once; interactive holds 15 to 25 frames a second at 640x360 on two cores; standard is clean
// after its samples; high resolves the detail texture; finest has no error of the march that the eye or the closed-form
// tests can find. reference is traced, not marched: it has no error but noise; its steps are what a path takes about.
constexpr RenderQuality render_quality(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {96, 80.0, 0.04, 4, 2, 1, false, true};
    case Quality::interactive:
      return {144, 55.0, 0.032, 4, 1, 1, false, true};
    case Quality::standard:
      return {256, 22.0, 0.016, 6, 1, 8, false};
    case Quality::high:
      return {400, 12.0, 0.011, 8, 1, 32, false};
    case Quality::finest:
      return {1024, 8.0, 0.004, 24, 1, 64, true};
    case Quality::reference:
      return {.max_steps = 256, .samples = 64, .float32 = true, .technique = Technique::path_tracing};
  }
  return {};
}

// What a stream is refined to: paths are traced for pictures that somebody waits for, not for views that may move.
constexpr Quality marched(Quality quality) {
  return render_quality(quality).technique == Technique::march ? quality : Quality::finest;
}

}  // namespace cloudscape
