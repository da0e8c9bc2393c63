// The paths under way, one a slot, kept in storage buffers from dispatch to dispatch; and the random numbers of each.
#ifndef TRACE_STATE
#define TRACE_STATE
#include "shared/trace_block.glsl"
#include "lib/hash.glsl"

struct Slot {
  vec4 origin_t;                  // of the ray: where it begins, how far it has come (m)
  vec4 direction_end;             // its direction, where it leaves the medium or meets a surface (m)
  vec4 next_surface;              // direction in which the path goes on after sunlight; distance of the surface (m)
  vec4 throughput_transmittance;  // of the path, of the ray towards the sun
  vec4 radiance_distance;         // of the sample so far; distance of its first event: > 0 medium, < 0 surface, 0 none yet
  vec4 sunlight_gap;              // radiance that the ray towards the sun brings if nothing stands in it; begin of its gap (m)
  vec4 hue_gap;                   // how likely the path was by each colour's phase function; end of the gap (m)
  uvec4 random;                   // key, numbers drawn, colour whose phase function draws the directions
  uvec4 place;                    // pixel, sample, mode, scattering order
};
layout(std430, binding = 0) buffer Slots { Slot slots[]; };
layout(std430, binding = 1) readonly buffer ListNow { uint list_now[]; };
layout(std430, binding = 2) writeonly buffer ListNext { uint list_next[]; };
// As server/render/path_tracer.cpp has it.
layout(std430, binding = 3) buffer Counters { uint next_pixel, listed, samples_done, flights, above_majorant; } counters;

const uint mode_idle = 0u;      // the slot waits for a pixel
const uint mode_new = 1u;       // it has one, and its sample is to begin
const uint mode_flight = 2u;    // of the path itself
const uint mode_sunlight = 3u;  // from a vertex of the path towards the sun

struct Path {
  vec3 origin, direction, next_direction, throughput, radiance, sunlight, hue;
  float t, end_m, surface_m, transmittance, first_m, gap_begin, gap_end;
  uvec2 key;
  uint drawn, colour, pixel, sample_number, mode, order;
};
Path path;

void load_path(uint slot) {
  Slot s = slots[slot];
  path.origin = s.origin_t.xyz, path.t = s.origin_t.w;
  path.direction = s.direction_end.xyz, path.end_m = s.direction_end.w;
  path.next_direction = s.next_surface.xyz, path.surface_m = s.next_surface.w;
  path.throughput = s.throughput_transmittance.xyz, path.transmittance = s.throughput_transmittance.w;
  path.radiance = s.radiance_distance.xyz, path.first_m = s.radiance_distance.w;
  path.sunlight = s.sunlight_gap.xyz, path.gap_begin = s.sunlight_gap.w;
  path.hue = s.hue_gap.xyz, path.gap_end = s.hue_gap.w;
  path.key = s.random.xy, path.drawn = s.random.z, path.colour = s.random.w;
  path.pixel = s.place.x, path.sample_number = s.place.y, path.mode = s.place.z, path.order = s.place.w;
}

void store_path(uint slot) {
  Slot s;
  s.origin_t = vec4(path.origin, path.t);
  s.direction_end = vec4(path.direction, path.end_m);
  s.next_surface = vec4(path.next_direction, path.surface_m);
  s.throughput_transmittance = vec4(path.throughput, path.transmittance);
  s.radiance_distance = vec4(path.radiance, path.first_m);
  s.sunlight_gap = vec4(path.sunlight, path.gap_begin);
  s.hue_gap = vec4(path.hue, path.gap_end);
  s.random = uvec4(path.key, path.drawn, path.colour);
  s.place = uvec4(path.pixel, path.sample_number, path.mode, path.order);
  slots[slot] = s;
}

// Each sample has a sequence of its own, whatever slot and dispatch it falls to: three numbers in [0, 1) a draw.
vec3 random_numbers() { return hash_unit(uvec3(path.key, path.drawn++)); }

float greatest(vec3 v) { return max(v.x, max(v.y, v.z)); }
#endif
