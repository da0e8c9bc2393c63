// Light shafts: what the shadows of the clouds take from the light that the air scatters towards the camera.
#ifndef RENDER_SHAFTS
#define RENDER_SHAFTS
#include "render/camera.glsl"
#include "render/sky.glsl"
#include "render/sun_depth.glsl"

// tuned: farther out shadows are narrower than the look-ups lie apart, which shows as noise. They fade on the way there.
const float farthest_shaft_m = 30000.0;
// tuned: look-ups along a ray for each step towards the sun above three: 4 in moving pictures, which have no time, 12 and 16 in others.
const float shaft_samples_per_step = 4.0;
const float most_shaft_samples = 16.0;

// tuned: share of the air's light, without the haze's own, that comes straight from the sun and not from the rest of the sky: half
// under a clear sky. More makes shadows in clean air black.
const float direct_share_of_air = 0.5;

// Radiance that is missing between the camera and what lies behind the clouds, and between it and the clouds.
struct AirShadow {
  vec3 behind, before;
};

// What the air up to a point scatters in but for the haze's first order, and that before its phase function.
struct AirSource {
  vec3 even, aerosol;
};

AirSource air_source(vec2 uv, float distance_m) {
  float row = aerial_row(distance_m);
  return AirSource(textureLod(aerial_table, vec3(uv, row), 0.0).xyz, textureLod(aerial_table, vec3(uv, row + 1.0 / 3.0), 0.0).xyz);
}

// The stretch of a ray on which clouds can stand between the air and the light.
vec2 shaded_stretch(CameraRay ray, float end_m) {
  end_m = min(end_m, farthest_shaft_m);
  vec2 below = volume_kind() == volume_noise ? intersect_altitude(ray.origin, ray.direction, cloud.march.w)
                                             : intersect_slab(ray.origin.z, ray.direction.z, -no_hit_m, cloud.march.w);
  return below.x > below.y ? vec2(1.0, -1.0) : vec2(max(below.x, 0.0), min(below.y, end_m));
}

// The look-ups lie closer to each other near the camera, where shadows are seen in most detail.
AirShadow air_shadow(CameraRay ray, float end_m, float cloud_m, float jitter) {
  AirShadow shadow = AirShadow(vec3(0.0), vec3(0.0));
  vec2 stretch = shaded_stretch(ray, end_m);
  bool shaded = has_sun_depth() && sky_kind() == sky_clear && frame.light_direction.z > 0.02 && stretch.y > stretch.x;
  float samples = shaded ? clamp(shaft_samples_per_step * (cloud.steps.w - 3.0), 4.0, most_shaft_samples) : 0.0;
  float beam_share = 1.0 - forwardness() * forwardness();
  float phase = phase_cornette_shanks(dot(ray.direction, frame.light_direction.xyz), frame.aerosol.x);
  float air_m = aerial_begin_m(camera_altitude_m(), ray.direction);
  vec2 uv = aerial_uv(ray.direction);
  AirSource last = AirSource(vec3(0.0), vec3(0.0));
  for (float i = 0.0; i < min(samples, 1.0); ++i) last = air_source(uv, stretch.x - air_m);
  for (float i = 0.0; i < samples; ++i) {
    float begin_m = mix(stretch.x, stretch.y, i * i / (samples * samples));
    float next_m = mix(stretch.x, stretch.y, (i + 1.0) * (i + 1.0) / (samples * samples));
    AirSource next = air_source(uv, next_m - air_m);
    float at_m = mix(begin_m, next_m, fract(jitter + golden_ratio * i));  // each by another share: their errors do not add up
    float depth = sun_depth_at(ray.origin + ray.direction * at_m);
    float near = 1.0 - at_m * at_m / (farthest_shaft_m * farthest_shaft_m);
    vec3 missing = (next.aerosol - last.aerosol) * phase * (1.0 - exp(-beam_share * depth)) +
                   (next.even - last.even) * direct_share_of_air * (1.0 - slab_transmittance(depth));
    missing *= near;
    shadow.behind += missing;
    shadow.before += missing * clamp((cloud_m - begin_m) / (next_m - begin_m), 0.0, 1.0);
    last = next;
  }
  return shadow;
}
#endif
