// targets: rgba16f
// The kept picture: the pixels that this frame marched, averaged with what the picture before has there, and the others from that
// picture, re-projected by the distance and the motion of what is seen. Radiance; samples in the average / 64.
#include "shared/frame_block.glsl"
#include "shared/resolve_block.glsl"
#include "lib/reprojection.glsl"
layout(binding = 0) uniform sampler2D marched_radiance;
layout(binding = 1) uniform sampler2D least_radiance;
layout(binding = 2) uniform sampler2D greatest_radiance;
layout(binding = 3) uniform sampler2D kept_before;

const float most_samples = 64.0;

// Where the picture before shows what this one has at a place (0..1 each, y down), and whether it does.
vec3 place_before(vec2 place, float closeness_per_km) {
  vec3 ray = view_ray(place, resolve.moved.w, float(resolve.kept.x) / float(resolve.kept.y));
  vec3 direction = normalize(ray.x * frame.camera_right.xyz + ray.y * frame.camera_up.xyz + frame.camera_forward.xyz);
  vec3 from_before = direction + 0.001 * closeness_per_km * (resolve.moved.xyz - resolve.drift.xyz);
  vec3 seen = vec3(dot(from_before, resolve.before_right.xyz), dot(from_before, resolve.before_up.xyz),
                   dot(from_before, resolve.before_forward.xyz));
  return place_of_view(seen, resolve.before_right.w, resolve.before_up.w);
}

PassOutput shade(ivec2 pixel) {
  int stride = resolve.kept.z;
  ivec2 block = pixel >> (stride >> 1);  // which is 1, 2 or 4: software divides integers one by one
  vec2 size = vec2(resolve.kept.xy);
  vec2 place = (vec2(pixel) + 0.5) / size;
  vec4 least = texelFetch(least_radiance, block, 0);
  vec3 before = place_before(place, least.w);
  float known = before.z * resolve.before_forward.w;
  float motion = clamp(length((before.xy - place) * size), 0.0, 1.0);
  vec4 kept = textureLod(kept_before, before.xy, 0.0);
  vec3 greatest = texelFetch(greatest_radiance, block, 0).xyz;
  vec3 margin = (greatest - least.xyz) * mix(resolve.trust.z, resolve.trust.w, motion);
  vec3 average = clamp(kept.xyz, least.xyz - margin, greatest + margin);
  float samples = min(kept.w * most_samples, mix(resolve.trust.x, resolve.trust.y, motion));
  // What is not known is what this frame marched, between its samples.
  vec2 among = ((vec2(pixel) - resolve.marched.xy) / float(stride) + 0.5) / vec2(textureSize(marched_radiance, 0));
  vec3 marched = textureLod(marched_radiance, among, 0.0).xyz;
  bool fresh = all(equal(pixel - block * stride, ivec2(resolve.marched.xy)));
  average = mix(marched, average, known);
  samples *= known;
  float weight = fresh ? 1.0 / (samples + 1.0) : 0.0;
  return PassOutput(vec4(mix(average, marched, weight), (samples + (fresh ? 1.0 : 0.0)) / most_samples));
}
