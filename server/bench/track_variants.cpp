#include "bench/track_variants.h"

#include <algorithm>

#include "core/error.h"

namespace cloudscape::bench {
namespace {

constexpr auto& names = EnumNames<TrackVariant>::names;

std::string list_of_names() {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

TrackVariant variant_of(const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InvalidInput("--variants", "has '" + name + "': must be all, or names among " + list_of_names());
  return static_cast<TrackVariant>(found - names.begin());
}

March thesis_march(March march) {
  const double unit_m = march.step_m.value_or(20.0);  // tuned: fine enough for the presets, and 500 reach far
  march.distance_field = false;
  march.structure = march.random_first_step = march.lighting = true;
  march.adaptive_step = false;
  march.step_m = unit_m;
  march.large_step_m = 20 * unit_m;
  march.max_distance_m = 500 * unit_m;
  march.max_steps = 576;  // 500 small steps, and room for the steps back at the structure's cells
  march.light_steps = 6;
  // "More than 100 units away they increase with 1 unit each unit" (3.2) would, read as a growth of 1, make the step at
  // the march's end longer than all clouds. With 0.05 it is 21 units there, as long as the large step.
  march.adaptive_start_m = 100 * unit_m;
  march.adaptive_growth = 0.05;
  return march;
}

void apply(TrackVariant variant, March& march, Phase& phase) {
  switch (variant) {
    case TrackVariant::base:
      break;
    case TrackVariant::structure_off:
      march.structure = false;
      break;
    case TrackVariant::distance_field:
      march.distance_field = true;
      break;
    case TrackVariant::adaptive_on:
      march.adaptive_step = true;
      break;
    case TrackVariant::light_off:
      march.lighting = false;
      break;
    case TrackVariant::phase_mie:
      phase.kind = PhaseKind::mie;
      break;
    case TrackVariant::phase_none:
      phase.kind = PhaseKind::none;
      break;
  }
}

}  // namespace

std::vector<TrackVariant> variants_of(const std::string& text) {
  std::vector<TrackVariant> variants{TrackVariant::base};
  if (text == "all") {
    for (std::size_t i = 1; i < names.size(); ++i) variants.push_back(static_cast<TrackVariant>(i));
    return variants;
  }
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const TrackVariant variant = variant_of(text.substr(begin, end - begin));
    if (std::find(variants.begin(), variants.end(), variant) == variants.end()) variants.push_back(variant);
    begin = end + 1;
  }
  return variants;
}

FrameRequest track_request(const Cloudscape& cloudscape, ImageSize size_px, TrackVariant variant) {
  auto changed = std::make_shared<Cloudscape>(cloudscape);
  FrameRequest request;
  request.display = cloudscape.view.display;
  request.march = thesis_march(cloudscape.view.march);
  changed->medium.phase.kind = PhaseKind::henyey_greenstein;
  apply(variant, request.march, changed->medium.phase);
  request.cloudscape = std::move(changed);
  request.size_px = size_px;
  request.quality = render_quality(Quality::standard);
  request.quality.march_divisor = request.quality.samples = 1;
  request.quality.smooth = false;
  request.quality.max_steps = *request.march.max_steps;
  return request;
}

const std::vector<ThesisTable>& thesis_tables() {
  using enum TrackVariant;
  static const std::vector<ThesisTable> tables{
      {"3.1", "preprocessed cloud structure", {{base, "on", 23.728955}, {structure_off, "off", 56.155690}}},
      {"3.2", "adaptive step length", {{base, "off", 23.728955}, {adaptive_on, "on", 21.761936}}},
      {"3.3", "light calculations", {{base, "on", 23.764996}, {light_off, "off", 12.553803}}},
      {"3.4",
       "phase function",
       {{base, "Henyey-Greenstein", 23.643466}, {phase_mie, "Mie", 25.999220}, {phase_none, "off", 22.585036}}}};
  return tables;
}

}  // namespace cloudscape::bench
