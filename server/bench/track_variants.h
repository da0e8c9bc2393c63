// The switches that the thesis' test track compares (Olajos 3.2), each against the same base.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/frame.h"

namespace cloudscape::bench {

enum class TrackVariant { base, structure_off, distance_field, adaptive_on, light_off, phase_mie, phase_none };

}  // namespace cloudscape::bench

namespace cloudscape {
template <>
struct EnumNames<bench::TrackVariant> {
  static constexpr std::array<std::string_view, 7> names{"base",      "structure-off", "distance-field", "adaptive-on",
                                                         "light-off", "phase-mie",     "phase-none"};
};
}  // namespace cloudscape

namespace cloudscape::bench {

// A comma-separated list of names, or "all". The base comes first, named or not. Throws InvalidInput.
std::vector<TrackVariant> variants_of(const std::string& text);

// Everything but pose, field of view and time: the thesis' step lengths and techniques, every pixel marched once, and
// what the variant changes. Base: structure (and not our distance field), random first step, light and
// Henyey-Greenstein on, steps of 1 and 20 units to 500 units (Olajos 2.4.1, 3.2). A unit is the cloudscape's own small
// step, or 20 m where it has none.
FrameRequest track_request(const Cloudscape& cloudscape, ImageSize size_px, TrackVariant variant);

// A figure of the thesis' tables. The thesis: GeForce GTX 680, 1280x720, mean over the track.
struct ThesisRow {
  TrackVariant variant;
  const char* label;
  double thesis_ms;
};
struct ThesisTable {
  const char *number, *title;
  std::vector<ThesisRow> rows;  // the base first
};
const std::vector<ThesisTable>& thesis_tables();

}  // namespace cloudscape::bench
