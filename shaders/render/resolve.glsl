// targets: rgba16f
// The kept picture: the pixels that this frame marched, averaged with what the picture before has there, and the others from that
// picture, re-projected by the distance and the motion of what is seen. Radiance; samples in the average / 64.
#include "shared/frame_block.glsl"
#include "shared/resolve_block.glsl"
#include "render/catmull_rom.glsl"
#include "lib/reprojection.glsl"
layout(binding = 0) uniform sampler2D marched;  // radiance, 1 / distance (1/km)
layout(binding = 1) uniform sampler2D kept_before;

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

// The four marched pixels around a pixel: between them, and what the least and greatest of each part is.
struct Marched {
  vec4 here, least, greatest;
};
Marched marched_around(ivec2 pixel, int stride) {
  ivec2 last = textureSize(marched, 0) - 1;
  vec2 among = (vec2(pixel) - resolve.marched.xy) / float(stride);
  ivec2 first = ivec2(floor(among));
  vec2 share = among - vec2(first);
  ivec2 low = clamp(first, ivec2(0), last), high = clamp(first + 1, ivec2(0), last);
  vec4 a = texelFetch(marched, low, 0), b = texelFetch(marched, ivec2(high.x, low.y), 0);
  vec4 c = texelFetch(marched, ivec2(low.x, high.y), 0), d = texelFetch(marched, high, 0);
  return Marched(mix(mix(a, b, share.x), mix(c, d, share.x), share.y), min(min(a, b), min(c, d)), max(max(a, b), max(c, d)));
}

// As much of the way from what is marched to what was kept as the range of the neighbours and the margin around it have room for: a
// colour keeps its hue on that way.
vec3 within(Marched around, vec3 kept, float margin) {
  vec3 way = kept - around.here.xyz;
  way = mix(vec3(0.0), way, lessThan(abs(way), vec3(1.0e30)));  // what is no number would spread from frame to frame
  vec3 widened = margin * (around.greatest.xyz - around.least.xyz) + 1.0e-6;
  vec3 room = mix(around.here.xyz - around.least.xyz, around.greatest.xyz - around.here.xyz, greaterThan(way, vec3(0.0))) + widened;
  vec3 shares = room / max(abs(way), vec3(1.0e-6));
  return around.here.xyz + way * min(1.0, min(shares.x, min(shares.y, shares.z)));
}

PassOutput shade(ivec2 pixel) {
  int stride = resolve.kept.z;
  vec2 size = vec2(resolve.kept.xy);
  vec2 place = (vec2(pixel) + 0.5) / size;
  Marched around = marched_around(pixel, stride);
  vec3 before = place_before(place, around.greatest.w);
  float known = before.z * resolve.before_forward.w;
  float motion = clamp(length((before.xy - place) * size), 0.0, 1.0);
  vec4 kept = catmull_rom(kept_before, before.xy, size);
  float margin = mix(resolve.trust.z, resolve.trust.w, motion);
  float samples = known * min(kept.w * most_samples, mix(resolve.trust.x, resolve.trust.y, motion));
  vec3 average = mix(around.here.xyz, within(around, kept.xyz, margin), known);
  ivec2 block = pixel >> (stride >> 1);  // the stride is 1, 2 or 4: software divides integers one by one
  bool fresh = all(equal(pixel - block * stride, ivec2(resolve.marched.xy)));
  float weight = fresh ? 1.0 / (samples + 1.0) : 0.0;
  return PassOutput(vec4(mix(average, around.here.xyz, weight), (samples + (fresh ? 1.0 : 0.0)) / most_samples));
}
