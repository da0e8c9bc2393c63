// A still as a person asks for it: by HTTP query, by JSON body or on the command line; one meaning, one validation.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/frame.h"
#include "settings/cloudscape_json.h"
#include "settings/still_documents.h"
#include "settings/text_values.h"

namespace cloudscape::settings {

struct StillLimits {
  int max_side_px = 4096;
  double max_megapixels = 9.0;  // 3840x2160
  // pixels * samples * steps * (1 + light steps) / 1e9, steps and light steps being the most that a ray may take.
  double max_gigasteps = 1500.0;  // tuned: as it was found safe for the quality `reference` at 0.9 megapixels
  double max_bake_mib = 128.0;    // of the cloudscape's textures
};

struct StillRequest {
  FrameRequest frame;
  Encoding encoding;
  std::string canonical;  // the same for requests that mean the same picture: document hash and every parameter
};

// The work of a picture in the unit of StillLimits::max_gigasteps.
double gigasteps_of(const FrameRequest& request);

using Parameters = std::vector<std::pair<std::string, std::string>>;  // decoded, in order

// cloudscape (required without `still`), still, position=E,N,U, azimuth_deg, elevation_deg, roll_deg, vertical_fov_deg,
// lens, width_m, width, height, quality, samples, time_s, sun_azimuth_deg, sun_elevation_deg, latitude_deg,
// longitude_deg, time_utc, exposure_ev, tone_curve, dither, format, jpeg_quality, exr_type. What is absent comes from
// the still that `still` names, if it does, from the document's `view`, then 640x360, standard, time 0, jpeg, 90, half.
// Throws InvalidInput (pointer "/name"; unknown or repeated parameter too), NotFound (cloudscape, still), OverLimit.
StillRequest still_from_parameters(const Parameters& parameters, const CloudscapeLibrary& library,
                                   const StillLimits& limits);

// As still_from_parameters, on top of a still's document, whose errors open with its source: "file.json#/image/width".
StillRequest still_from_document(const StillDocument& document, const Parameters& parameters,
                                 const CloudscapeLibrary& library, const StillLimits& limits);

// {"title", "description", "cloudscape": name or document, "camera": {position_m, azimuth_deg, ..., lens: {...}},
// "image": {width, height, quality, samples, time_s, exposure_ev, tone_curve, dither, format, jpeg_quality, exr_type},
// "sun": {azimuth_deg, elevation_deg, place: {latitude_deg, longitude_deg, time_utc}}}
StillRequest still_from_json(std::string_view body, const CloudscapeLibrary& library, const StillLimits& limits);

// The query's parameters, for the OpenAPI document and the command line.
std::vector<ParameterInfo> still_parameters(const StillLimits& limits = {});

}  // namespace cloudscape::settings
