// Light shafts: what the shadows of the clouds take from the light that the air scatters towards the camera.
#ifndef RENDER_SHAFTS
#define RENDER_SHAFTS
#include "render/camera.glsl"
#include "render/sky.glsl"
#include "render/sun_depth.glsl"

// tuned: farther out shadows are narrower than the look-ups lie apart, which shows as noise. They fade on the way there.
const float farthest_shaft_m = 15000.0;
// tuned: look-ups along a ray: 2 with the four steps towards the light of moving pictures, which have no time and are averaged over frames,
// 8 and 12 in others.
const float fewest_shaft_samples = 2.0;
const float most_shaft_samples = 12.0;

// tuned: share of the air's light, without the haze's own, that comes straight from the sun and not from the rest of the sky: half
// under a clear sky. More makes shadows in clean air black.
const float direct_share_of_air = 0.5;

// Radiance that is missing between the camera and what lies behind the clouds, and between it and the clouds.
struct AirShadow {
  vec3 behind, before;
};

// What the air up to a point scatters in but for the haze's first order, and that before its phase function; green light let through.
struct AirSource {
  vec3 even, aerosol;
  float transmittance;
};

AirSource air_source(vec2 uv, float distance_m) {
  float row = aerial_row(distance_m);
  return AirSource(textureLod(aerial_table, vec3(uv, row), 0.0).xyz, textureLod(aerial_table, vec3(uv, row + 1.0 / 3.0), 0.0).xyz,
                   textureLod(aerial_table, vec3(uv, row + 2.0 / 3.0), 0.0).y);
}

// The stretch of a ray on which clouds can stand between the air and the light.
vec2 shaded_stretch(CameraRay ray, float end_m) {
  end_m = min(end_m, farthest_shaft_m);
  vec2 below = volume_kind() == volume_noise ? intersect_altitude(ray.origin, ray.direction, cloud.march.w)
                                             : intersect_slab(ray.origin.z, ray.direction.z, -no_hit_m, cloud.march.w);
  return below.x > below.y ? vec2(1.0, -1.0) : vec2(max(below.x, 0.0), min(below.y, end_m));
}

// How much light a point of the ray scatters to the camera, but for a factor: haze and air are denser below, and what lies far off is
// hidden by what lies before it.
float air_weight(CameraRay ray, float at_m, float hidden_per_m) {
  float altitude_m = altitude_of(ray.origin + ray.direction * at_m);
  return exp(-max(altitude_m, 0.0) / frame.atmosphere.w - hidden_per_m * at_m);
}

// Look-ups share the light between them by what their parts of the ray scatter; they lie closer to each other near the camera, where
// shadows are seen in most detail. Sums of what is missing of the haze's beam and of the air's light, of what the haze has instead of the
// beam, and of weights: of all of the ray, and before the cloud.
struct ShaftSums {
  vec4 behind, before;
};

ShaftSums shaft_sums(CameraRay ray, vec2 stretch, float cloud_m, float hidden_per_m, float samples, float jitter) {
  ShaftSums sums = ShaftSums(vec4(0.0), vec4(0.0));
  float beam_share = 1.0 - forwardness() * forwardness();
  float begin_m = stretch.x;
  float i = 0.0;
  do {
    float next_m = mix(stretch.x, stretch.y, (i + 1.0) * (i + 1.0) / (samples * samples));
    float at_m = mix(begin_m, next_m, fract(jitter + golden_ratio * i));  // each by another share: their errors do not add up
    float weight = (next_m - begin_m) * air_weight(ray, at_m, hidden_per_m);
    float depth = sun_depth_at(ray.origin + ray.direction * at_m);
    float near = 1.0 - at_m * at_m / (farthest_shaft_m * farthest_shaft_m);
    float beam = exp(-beam_share * depth), through = slab_transmittance(depth);
    vec4 missing = weight * vec4(near * vec3(1.0 - beam, 1.0 - through, max(through - beam, 0.0)), 1.0);
    sums.behind += missing;
    sums.before += missing * clamp((cloud_m - begin_m) / (next_m - begin_m), 0.0, 1.0);
    begin_m = next_m;
  } while (++i < samples);
  return sums;
}

// What the clouds let through but not as a beam comes to the haze from all sides.
vec3 missing_light(vec4 sums, AirSource first, AirSource last, float phase) {
  float haze = sums.x * phase - sums.z * phase_isotropic;
  vec3 light = haze * (last.aerosol - first.aerosol) + sums.y * direct_share_of_air * (last.even - first.even);
  return light / max(sums.w, 1.0e-30);
}

AirShadow air_shadow(CameraRay ray, float end_m, float cloud_m, float jitter) {
  AirShadow shadow = AirShadow(vec3(0.0), vec3(0.0));
  vec2 stretch = shaded_stretch(ray, end_m);
  bool shaded = has_sun_depth() && sky_kind() == sky_clear && frame.light_direction.z > 0.02 && stretch.y > stretch.x;
  if (shaded) {
    float air_m = aerial_begin_m(camera_altitude_m(), ray.direction);
    vec2 uv = aerial_uv(ray.direction);
    AirSource first = air_source(uv, stretch.x - air_m), last = air_source(uv, stretch.y - air_m);
    AirSource at_cloud = air_source(uv, clamp(cloud_m, stretch.x, stretch.y) - air_m);
    float hidden_per_m = -log(max(last.transmittance, 1.0e-4)) / max(stretch.y - air_m, 1.0);
    float samples = clamp(3.0 * cloud.steps.w - 10.0, fewest_shaft_samples, most_shaft_samples);
    ShaftSums sums = shaft_sums(ray, stretch, cloud_m, hidden_per_m, samples, jitter);
    float phase = phase_cornette_shanks(dot(ray.direction, frame.light_direction.xyz), frame.aerosol.x);
    shadow = AirShadow(missing_light(sums.behind, first, last, phase), missing_light(sums.before, first, at_cloud, phase));
  }
  return shadow;
}
#endif
