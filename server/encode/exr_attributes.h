// What an EXR file says about how its picture was made.
#pragma once
#include <OpenEXR/ImfHeader.h>

#include "core/frame.h"

namespace cloudscape::encode {

// camera_east_m, camera_north_m, camera_altitude_m, camera_azimuth_deg, camera_elevation_deg, camera_roll_deg,
// lens_kind, lens_vertical_fov_deg (perspective), lens_width_m (orthographic), sun_azimuth_deg, sun_elevation_deg,
// sun_irradiance, time_s, exposure_ev (not applied to radiance), cloudscape_hash, software, samples and the quality_*
// numbers; of a path-traced picture trace_seed, trace_atmosphere and trace_max_scattering_order (0: none) in their
// place. Doubles where metres and degrees need them; only types of the format's own list.
void add_attributes(Imf::Header& header, const Frame& frame);

}  // namespace cloudscape::encode
