// A still as a person asks for it: by HTTP query, by JSON body or on the command line; one meaning, one validation.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/frame.h"
#include "settings/cloudscape_json.h"
#include "settings/text_values.h"

namespace cloudscape::settings {

struct StillLimits {
  int max_side_px = 4096;
  double max_megapixels = 9.0;  // 3840x2160
  double max_gigasteps = 60.0;  // pixels * samples * max_steps / 1e9
  double max_bake_mib = 128.0;  // of the cloudscape's textures
};

struct StillRequest {
  FrameRequest frame;
  Encoding encoding;
  std::string canonical;  // the same for requests that mean the same picture: document hash and every parameter
};

using Parameters = std::vector<std::pair<std::string, std::string>>;  // decoded, in order

// cloudscape (required), position=E,N,U, azimuth_deg, elevation_deg, roll_deg, vertical_fov_deg, lens, width_m, width,
// height, quality, samples, time_s, sun_azimuth_deg, sun_elevation_deg, latitude_deg, longitude_deg, time_utc,
// exposure_ev, tone_curve, dither, format, jpeg_quality, exr_type. What is absent comes from the document's `view`,
// then 640x360, standard, time 0, jpeg, 90, half. Throws InvalidInput (pointer "/name"; unknown or repeated parameter
// too), NotFound (cloudscape), OverLimit.
StillRequest still_from_parameters(const Parameters& parameters, const CloudscapeLibrary& library,
                                   const StillLimits& limits);

// {"cloudscape": name or document, "camera": {position_m, azimuth_deg, ..., lens: {...}}, "image": {width, height,
// quality, samples, time_s, exposure_ev, tone_curve, dither, format, jpeg_quality, exr_type}, "sun": {azimuth_deg,
// elevation_deg, place: {latitude_deg, longitude_deg, time_utc}}}
StillRequest still_from_json(std::string_view body, const CloudscapeLibrary& library, const StillLimits& limits);

// The query's parameters, for the OpenAPI document and the command line.
std::vector<ParameterInfo> still_parameters(const StillLimits& limits = {});

}  // namespace cloudscape::settings
