// targets: rgba16f
// The kept picture: the pixels that this frame marched, averaged with what the picture before has there, and the others from that
// picture, re-projected by the distance and the motion of what is seen. Radiance; samples in the average / 64.
// The tiles (of 8x8 pixels) of what was not seen before are marked, and nothing is in its average; those of the discs of sun and moon, too.
// With OUTLINES, of land, target 1: 1 / distance of what is seen (1/km).
#include "shared/frame_block.glsl"
#include "shared/resolve_block.glsl"
#include "render/catmull_rom.glsl"
#include "render/discs.glsl"
#include "lib/reprojection.glsl"
layout(binding = 0) uniform sampler2D marched;  // radiance, 1 / distance (1/km; of clouds, or less than 0)
layout(binding = 1) uniform sampler2D kept_before;

layout(binding = 7, r32f) writeonly uniform image2D newly_seen;  // by tiles

const float most_samples = 64.0;
const float hardly_any = 1.0 / 64.0;  // samples, where something else than this pixel was seen

// Where the picture before shows what this one has at a place (0..1 each, y down), and whether it does.
vec3 place_before(vec2 place, float closeness_per_km) {
  vec3 ray = view_ray(place, resolve.moved.w, float(resolve.kept.x) / float(resolve.kept.y));
  vec3 direction = normalize(ray.x * frame.camera_right.xyz + ray.y * frame.camera_up.xyz + frame.camera_forward.xyz);
  vec3 from_before = direction + 0.001 * closeness_per_km * (resolve.moved.xyz - resolve.drift.xyz);
  vec3 seen = vec3(dot(from_before, resolve.before_right.xyz), dot(from_before, resolve.before_up.xyz),
                   dot(from_before, resolve.before_forward.xyz));
  return place_of_view(seen, resolve.before_right.w, resolve.before_up.w);
}

// The four marched pixels around a pixel: between them, and what the least and greatest of each part is; how close the nearest and the
// farthest of what they see is.
struct Marched {
  vec4 here, least, greatest;
  float near, far;
};
Marched marched_around(ivec2 pixel, int stride) {
  ivec2 last = textureSize(marched, 0) - 1;
  vec2 among = (vec2(pixel) - resolve.marched.xy) / float(stride);
  ivec2 first = ivec2(floor(among));
  vec2 share = among - vec2(first);
  ivec2 low = clamp(first, ivec2(0), last), high = clamp(first + 1, ivec2(0), last);
  vec4 a = texelFetch(marched, low, 0), b = texelFetch(marched, ivec2(high.x, low.y), 0);
  vec4 c = texelFetch(marched, ivec2(low.x, high.y), 0), d = texelFetch(marched, high, 0);
  vec4 least = min(min(a, b), min(c, d)), greatest = max(max(a, b), max(c, d));
  vec4 closeness = abs(vec4(a.w, b.w, c.w, d.w));
  vec2 far = min(closeness.xy, closeness.zw);
  return Marched(mix(mix(a, b, share.x), mix(c, d, share.x), share.y), least, greatest, max(-least.w, greatest.w), min(far.x, far.y));
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

// What a pixel shows of what the rays around it have met: how close it is, where that was seen before, and whether it was (0 or 1).
struct Seen {
  float closeness;
  vec2 before;
  float known;
};

// Where land moves before something far by more than half a pixel, the picture before tells which of them a pixel shows: the outline has
// moved as the land has. (Clouds have no such outline: their edges fray.) Where it was neither that it shows now, it was hidden.
#ifdef OUTLINES
layout(binding = 2) uniform sampler2D closeness_before;

bool was_near(vec2 before, float middle) {
  ivec2 size = textureSize(closeness_before, 0);  // it may have been kept finer or coarser
  return texelFetch(closeness_before, clamp(ivec2(before * vec2(size)), ivec2(0), size - 1), 0).x >= middle;
}
#endif

Seen seen_at(vec2 place, Marched around) {
  float near = around.near, far = around.far;
  vec3 at = place_before(place, near);
  Seen seen = Seen(near, at.xy, at.z);
#ifdef OUTLINES
  int edge = -around.least.w >= near && (near - far) * resolve.marched.w > 0.5 ? 1 : 0;
  for (int i = 0; i < edge; ++i) {  // a loop, which software leaves out
    float middle = 0.5 * (near + far);
    vec3 behind = place_before(place, far);
    if (!was_near(at.xy, middle)) seen = Seen(far, behind.xy, was_near(behind.xy, middle) ? 0.0 : behind.z);
  }
#endif
  return seen;
}

PassOutput shade(ivec2 pixel) {
  int stride = resolve.kept.z;
  vec2 size = vec2(resolve.kept.xy);
  vec2 place = (vec2(pixel) + 0.5) / size;
  Marched around = marched_around(pixel, stride);
  ivec2 block = pixel >> (stride >> 1);  // the stride is 1, 2 or 4: software divides integers one by one
  bool fresh = all(equal(pixel - block * stride, ivec2(resolve.marched.xy)));
  Seen seen = seen_at(place, around);
#ifdef OUTLINES
  // A ray that met something else than the picture before had there begins anew.
  bool other = fresh && around.here.w < 0.0 && (seen.closeness + around.here.w) * resolve.marched.w > 0.5;
  if (other) seen.known = 0.0;
#endif
  float known = seen.known * resolve.before_forward.w;
  float motion = clamp(length((seen.before - place) * size), 0.0, 1.0);
  vec4 kept = catmull_rom(kept_before, seen.before, size);
  float margin = mix(resolve.trust.z, resolve.trust.w, motion);
  float samples = known * min(kept.w * most_samples, mix(resolve.trust.x, resolve.trust.y, motion));
  vec3 average = mix(around.here.xyz, within(around, kept.xyz, margin), known);
  float weight = fresh ? 1.0 / (samples + 1.0) : 0.0;
  bool unseen = seen.known == 0.0 && seen.closeness <= resolve.drift.w;
  bool newly = resolve.kept.w != 0 && unseen && !fresh;
  int marked = newly || in_disc(pixel) ? 1 : 0;
  for (int i = 0; i < marked; ++i) imageStore(newly_seen, pixel >> 3, vec4(1.0));
  samples = newly ? 0.0 : max(samples + (fresh ? 1.0 : 0.0), hardly_any);
  vec4 kept_now = vec4(mix(average, around.here.xyz, weight), samples / most_samples);
#ifdef OUTLINES
  return PassOutput(kept_now, vec4(fresh ? abs(around.here.w) : seen.closeness));
#else
  return PassOutput(kept_now);
#endif
}
