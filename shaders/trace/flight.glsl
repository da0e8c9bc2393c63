// A ray on its way: from one place where something is decided to the next.
#ifndef TRACE_FLIGHT
#define TRACE_FLIGHT
#include "trace/state.glsl"
#include "trace/bounds.glsl"
#include "lib/sampling.glsl"

const int event_none = 0;
const int event_collision = 1;  // of the path with a particle of the clouds
const int event_arrival = 2;    // where the medium ends, or at a surface, or the ray towards the sun is dark
const int event_in_air = 3;     // the path is scattered by the air, where that is traced
const float weak_throughput = 0.25;  // tuned: roulette from here on; more ends paths that still bring light, less wastes time
const float weak_sunlight_per_sr = 0.1;  // tuned: 0.1 saves a quarter of the time for 1 % more noise, 1 brings a fifth more noise
const float weak_transmittance = 0.1;

uint flights = 0u;
uint above_majorant = 0u;

// Where a path turns, and towards which point of the sun it looks. What the sun adds and where the path goes on stand in `path`.
struct Vertex {
  vec3 position, sun;
};

// Russian roulette on what is weaker than 1: nothing, or the strength 1.
vec3 survivor(vec3 light, float strength, float u) {
  return strength >= 1.0 ? light : u < strength ? light / strength : vec3(0.0);
}
void roulette(float u) { path.throughput = survivor(path.throughput, greatest(path.throughput) / weak_throughput, u); }

// Most vertices of a long path have the sun far from ahead and would bring little of it: only some of them look for it.
void sunlight_roulette(float u, float irradiance) {
  path.sunlight = survivor(path.sunlight, greatest(path.sunlight) / (weak_sunlight_per_sr * irradiance), u);
}

// Far out 32 bits know no shorter way than this one, and a ray must not stop.
float onward_m(float free_m) { return max(free_m, 1.2e-7 * path.t); }

float after_gap(float t) { return t > path.gap_begin && t < path.gap_end ? path.gap_end : t; }

// What a tentative collision with cloud turns out to be, at `path.t`; u, roulette: random numbers.
int meet_cloud(float density_bound, float u, float roulette) {
  float ratio = density_at(path.origin + path.t * path.direction) / density_bound;
  if (ratio > 1.0001) ++above_majorant;
  if (path.mode != mode_sunlight) return u < ratio ? event_collision : event_none;
  path.transmittance *= max(0.0, 1.0 - ratio);
  if (path.transmittance < weak_transmittance)
    path.transmittance = roulette * weak_transmittance < path.transmittance ? weak_transmittance : 0.0;
  return path.transmittance <= 0.0 ? event_arrival : event_none;
}
#endif
