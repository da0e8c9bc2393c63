// What sky and ground add to the light in the clouds, where the light model does not solve for it. Any light model may ask, if the volume
// of visibility is bound.
#ifndef RENDER_AMBIENT
#define RENDER_AMBIENT
#include "render/sky.glsl"
#include "render/sun_depth.glsl"
layout(binding = 15) uniform sampler3D ambient_visibility;  // render/ambient_visibility.comp

const vec3 part_share = vec3(0.25, 0.25, 0.5);  // of the sphere: above, beside, below

// Light of sky and ground, as far as it is scattered towards the camera along a view ray.
struct AmbientLight {
  vec3 above, beside, below;
  mat3 parts;         // the same, scattered evenly
  vec3 part_weights;  // of above, beside and below, as of a light of 1 from everywhere
};

// Light of a part of the sphere goes on in its own direction rather than back: a phase function of two terms, (1 + 3 g cos) / 4 pi,
// which is never negative up to g = 1/3. tuned: what is left of the droplets' asymmetry after some orders.
float ambient_asymmetry() {
  return phase_has_asymmetry() ? clamp(0.4 * cloud.phase.x, -0.33, 0.33) : 0.0;
}
// `solid_angle`: the part's share of the sphere. `cosine`: mean of that between its directions and the view ray's. All weights add up to 1.
float ambient_weight(float solid_angle, float cosine, float g) { return solid_angle * (1.0 + 3.0 * g * cosine); }

AmbientLight ambient_light(vec3 direction) {
  AmbientLight light;
  vec2 azimuth = from_light_azimuth(direction.xy);
  float g = ambient_asymmetry();
  vec3 beside = surroundings(1) + surroundings(2) + surroundings(3) + surroundings(4);
  light.parts = mat3(surroundings(0) * part_share.x, beside * (0.25 * part_share.y), surroundings(5) * part_share.z);
  light.part_weights = part_share * (1.0 + 3.0 * g * direction.z * vec3(0.75, 0.25, -0.5));
  light.above = surroundings(0) * light.part_weights.x;
  light.below = surroundings(5) * light.part_weights.z;
  light.beside = surroundings(1) * ambient_weight(0.0625, 0.87 * azimuth.x + 0.25 * direction.z, g) +
                 surroundings(2) * ambient_weight(0.0625, 0.87 * azimuth.y + 0.25 * direction.z, g) +
                 surroundings(3) * ambient_weight(0.0625, -0.87 * azimuth.x + 0.25 * direction.z, g) +
                 surroundings(4) * ambient_weight(0.0625, -0.87 * azimuth.y + 0.25 * direction.z, g);
  return light;
}

// Light of sky and ground scattered towards the camera at p, height h (0..1) in the medium. What the cloud hides of them is as bright as
// p itself: so that as much comes out of a cloud that absorbs nothing as goes in.
vec3 visible_ambient(AmbientLight light, vec3 p, Land land) {
  vec3 seen = in_light_volume(ambient_visibility, p, land).xyz;
  float albedo = cloud.medium.y / cloud.medium.x;
  float open = dot(seen, part_share);
  vec3 inside = light.parts * seen * (albedo / (1.0 - albedo * (1.0 - open)));
  return light.above * seen.x + light.beside * seen.y + light.below * seen.z + inside * (1.0 - dot(light.part_weights, seen));
}

// tuned, where there is no volume of visibility: the sky is hidden by the cloud above, the horizon by the cloud beside and the ground by
// the cloud below, in proportion to the height.
vec3 ambient_by_height(AmbientLight light, float h) {
  float above = mix(0.3, 1.0, smoothstep(0.0, 1.0, h));
  float beside = mix(0.5, 0.9, h);
  float below = (1.0 - h) * (1.0 - h);
  return light.above * above + light.beside * beside + light.below * below;
}

vec3 ambient(AmbientLight light, vec3 p, float h, Land land) {
  return cloud.medium.z * (is_textured() ? visible_ambient(light, p, land) : ambient_by_height(light, h));
}
#endif
