// Camera, lens, sun, time, quality, document and program as attributes of an EXR header.
#include "encode/exr_attributes.h"

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfEnvmapAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <string>

#include "core/content_hash.h"
#include "encode/formats.h"

namespace cloudscape::encode {
namespace {

void add(Imf::Header& header, const char* name, double value) { header.insert(name, Imf::DoubleAttribute(value)); }
void add(Imf::Header& header, const char* name, int value) { header.insert(name, Imf::IntAttribute(value)); }
void add(Imf::Header& header, const char* name, const std::string& value) {
  header.insert(name, Imf::StringAttribute(value));
}

void add_camera(Imf::Header& header, const CameraPose& pose, const Lens& lens) {
  add(header, "camera_east_m", pose.position_m.x);
  add(header, "camera_north_m", pose.position_m.y);
  add(header, "camera_altitude_m", pose.position_m.z);
  add(header, "camera_azimuth_deg", pose.azimuth_deg);
  add(header, "camera_elevation_deg", pose.elevation_deg);
  add(header, "camera_roll_deg", pose.roll_deg);
  add(header, "lens_kind", std::string(name_of(lens.kind)));
  if (lens.kind == LensKind::perspective) add(header, "lens_vertical_fov_deg", lens.vertical_fov_deg);
  if (lens.kind == LensKind::orthographic) add(header, "lens_width_m", lens.width_m);
  if (lens.kind == LensKind::panorama) Imf::addEnvmap(header, Imf::ENVMAP_LATLONG);
}

void add_sun(Imf::Header& header, const Sun& sun) {
  add(header, "sun_azimuth_deg", sun.azimuth_deg);
  add(header, "sun_elevation_deg", sun.elevation_deg);
  const Imath::V3d irradiance(sun.irradiance.x, sun.irradiance.y, sun.irradiance.z);
  header.insert("sun_irradiance", Imf::V3fAttribute(Imath::V3f(irradiance)));
}

// A path-traced picture has no steps, but what its random numbers depend on.
void add_tracing(Imf::Header& header, const Tracing& tracing) {
  add(header, "trace_seed", static_cast<double>(tracing.seed));
  add(header, "trace_atmosphere", std::string(name_of(tracing.atmosphere)));
  add(header, "trace_max_scattering_order", tracing.max_scattering_order.value_or(0));
}

void add_quality(Imf::Header& header, const RenderQuality& quality) {
  add(header, "quality_max_steps", quality.max_steps);
  add(header, "quality_step_m", quality.step_m);
  add(header, "quality_step_growth", quality.step_growth);
  add(header, "quality_light_steps", quality.light_steps);
  add(header, "quality_march_divisor", quality.march_divisor);
  add(header, "quality_samples", quality.samples);
  add(header, "quality_float32", quality.float32 ? 1 : 0);
}

}  // namespace

void add_attributes(Imf::Header& header, const Frame& frame) {
  const FrameRequest& request = frame.request;
  add_camera(header, request.pose, request.lens);
  add_sun(header, request.cloudscape->sun);
  if (request.quality.technique == Technique::path_tracing)
    add_tracing(header, request.tracing);
  else
    add_quality(header, request.quality);
  add(header, "samples", frame.samples);
  add(header, "time_s", request.time_s);
  add(header, "exposure_ev", request.display.exposure_ev);
  add(header, "cloudscape_hash", content_hash(*request.cloudscape));
  add(header, "software", software());
}

}  // namespace cloudscape::encode
