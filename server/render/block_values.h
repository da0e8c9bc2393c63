// Requests to uniform blocks: where doubles of the document become floats of the device.
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "bake/baked_cloudscape.h"
#include "core/frame.h"
#include "render/blocks.h"
#include "render/in_scatter_plan.h"

namespace cloudscape::render {

// World-space directions of the camera's axes. Azimuth clockwise from north, elevation up, positive roll turns it
// clockwise.
struct CameraAxes {
  glm::dvec3 right, up, forward;
};
CameraAxes camera_axes(const CameraPose& pose);

// Width of a pixel in the middle of the picture: that of parallel rays (m), and growth for each metre of distance.
glm::dvec2 pixel_widths(const FrameRequest& request);

// Unit vector from azimuth and elevation, degrees.
glm::dvec3 direction_of(double azimuth_deg, double elevation_deg);

// Whether density comes from a texture and not from a formula.
constexpr bool is_textured(VolumeKind kind) { return kind == VolumeKind::noise || is_from_file(kind); }

// What the march mixes the shape texture's finer channels in with.
std::array<double, 3> mixing_weights(const Cloudscape& sky);

// Itself, but for a volume from a file, which is marched as a shape texture that is density itself, in the box where
// the file or the document puts it. Throws UnusableFile if that box is none.
FrameRequest as_marched(const FrameRequest& request, const bake::BakedCloudscape& baked);

// As seen by nobody: whatever does not depend on the camera is as in a frame at time 0. `below`: the point at sea level
// that the device's positions are relative to.
FrameRequest seen_by_nobody(const std::shared_ptr<const Cloudscape>& cloudscape, const glm::dvec3& below);

// How fast the slow change of coverage moves the tile (tiles a metre) and the threshold (a metre), at most.
struct LandSlopes {
  double shift_per_m = 0, threshold_per_m = 0;
};
LandSlopes land_slopes(const Cloudscape& sky, const bake::BakedCloudscape& baked);

// `sample`: index in the average that the frame belongs to; 0 looks through the middle of the pixel.
FrameBlock frame_block(const FrameRequest& request, int sample);
// Of the frame block: sun, moon, stars, and what lights the clouds.
bool moon_lights(const Cloudscape& sky);               // whether it is the moon that lights clouds and ground
glm::dvec3 direction_of_light(const Cloudscape& sky);  // towards it, unit
double light_azimuth_deg(const Cloudscape& sky);       // of that or of the sun
void set_lights(FrameBlock& block, const FrameRequest& request);
// Of a document as it is marched.
InScatterPlan in_scatter_plan_of(const Cloudscape& marched, const bake::BakedCloudscape& baked);
bake::DistancePlan distance_plan_of(const Cloudscape& marched, const bake::BakedCloudscape& baked);
CloudBlock cloud_block(const FrameRequest& request, const bake::BakedCloudscape& baked);
// How far east and north the clouds have drifted, m; formulas stand still.
glm::dvec2 drift_of_clouds(const FrameRequest& request);
// The water block without its view of the clouds.
WaterBlock water_block(const FrameRequest& request);

}  // namespace cloudscape::render
