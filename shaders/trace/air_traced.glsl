// The air as paths meet it, in a clear sky: Rayleigh and aerosol scattering, ozone and aerosol absorption, in three colours at once.
//
// Of the air no collision is drawn, since most of a clear sky's paths would miss it. A flight draws its collision with cloud as if
// there were no air, meets tentative places in the air on the way, and carries a weight for each colour past them (ratio tracking). One
// of these places is kept, by reservoir sampling (Chao 1982) in proportion to what it scatters; where the flight ends, the path turns
// there or goes on from its end, in proportion to their weights. Any density of places is right on average.
#ifndef TRACE_AIR_TRACED
#define TRACE_AIR_TRACED
#include "trace/flight.glsl"
#include "trace/world.glsl"

struct AirSlot {
  vec4 colours_t;  // of the place that is kept: weights by colour, their mean 1; distance along the ray, m
  vec4 flight;     // weight of all places so far; where the cloud's stretch begins and ends, m; 1 once the path has turned
};
layout(std430, binding = 4) buffer AirSlots { AirSlot air_slots[]; };

const bool air_is_traced = true;
AirSlot kept;
bool first_event = false;

void load_air(uint slot) { kept = air_slots[slot]; }
void store_air(uint slot) { air_slots[slot] = kept; }
void begin_path() { path.first_m = 0.0, kept.flight.w = 0.0; }
bool is_first() { return first_event; }
void see_through_air(float distance_m, float sign) {}
void leave_world() {}
float mean_of(vec3 v) { return (v.x + v.y + v.z) / 3.0; }


// Distance to the planet at sea level, where there may be no ground; no_hit_m: none.
float planet_distance_m(vec3 origin, vec3 direction) {
  vec2 hit = intersect_altitude(origin, direction, 0.0);
  return hit.x <= hit.y && hit.y > 0.0 ? max(hit.x, 0.0) : no_hit_m;
}

// Of the sun or the moon, by turns where both light the air.
Sunlight sunlight_at(vec3 p, float u, float turn) {
  float lights = float(frame.sample_info.z);
  bool second = u * lights >= 1.0;
  vec4 disc = second ? frame.second_direction : frame.light_direction;
  vec3 irradiance = second ? frame.second_irradiance.xyz : frame.light_irradiance.xyz;
  vec3 direction = towards_disc(disc, fract(u * lights), turn);
  float above_m = max(altitude_far_of(p), 0.0);
  vec3 arrives = space_transmittance(above_m, dot(up_at(p), direction));
  if (planet_distance_m(p, direction) < no_hit_m) arrives = vec3(0.0);
  return Sunlight(direction, lights * irradiance * arrives);
}

void begin_flight(Stretch stretch) {
  bool clouds = cloud.medium.x > 0.0 && path.transmittance > 0.0;
  float cloud_end_m = clouds ? min(stretch.end, path.surface_m) : -1.0;
  kept.flight.yz = vec2(stretch.begin, cloud_end_m);
  path.t = stretch.begin, path.end_m = cloud_end_m;
  if (path.mode == mode_sunlight) return;
  kept.flight.x = 0.0;
  vec2 air = intersect_altitude(path.origin, path.direction, atmosphere_top_m);
  path.t = max(air.x, 0.0);
  path.end_m = min(air.x <= air.y ? air.y : -1.0, min(path.surface_m, planet_distance_m(path.origin, path.direction)));
}

// Cloud on the ray ahead: none before its stretch, in the gap, and beyond.
Bound cloud_ahead(vec3 p) {
  if (path.t < kept.flight.y) return Bound(0.0, kept.flight.y - path.t);
  if (path.t >= kept.flight.z) return Bound(0.0, no_hit_m);
  if (path.t >= path.gap_begin && path.t < path.gap_end) return Bound(0.0, path.gap_end - path.t);
  return density_bound(p, path.direction);
}

// Tentative places in the air, 1/m, and how far ahead there are so many.
struct AirAhead {
  float per_m, free_m;
};

AirAhead air_ahead(vec3 p) {
  if (path.mode == mode_sunlight) return AirAhead(0.0, no_hit_m);
  const float places = 4.0;  // tuned: to a collision at most, on average; more make less noise and cost flights
  float altitude_m = max(altitude_far_of(p), 0.0);
  float climb = dot(up_at(p), path.direction);
  // The ray curves away from the planet, so that it does not sink faster than here.
  float lowest_m = climb < 0.0 ? max(0.0, altitude_m - max(4000.0, 0.5 * altitude_m)) : altitude_m;
  Atmosphere air = frame_atmosphere();
  vec3 ozone = ozone_absorption_per_m() * (air.ozone * ozone_density(max(lowest_m, 25000.0)));
  float per_m = places * greatest(air_at(lowest_m, air).extinction + ozone);
  float sinks_m = lowest_m > 0.0 && climb < 0.0 ? (altitude_m - lowest_m) / -climb : no_hit_m;
  return AirAhead(per_m, min(sinks_m, 1.0 / max(per_m, 1.0e-9)));
}

// A tentative place in the air, at `path.t`.
void pass_air(float per_m, float u) {
  AirAt air = air_at(altitude_far_of(path.origin + path.t * path.direction), frame_atmosphere());
  vec3 scattered = path.throughput * (air.rayleigh + vec3(air.aerosol)) / per_m;
  float weight = mean_of(scattered);
  kept.flight.x += weight;
  if (u * kept.flight.x < weight) kept.colours_t = vec4(scattered / weight, path.t);
  path.throughput *= 1.0 - air.extinction / per_m;
}

// The ray goes on to its next event, for as many flights as a round has.
int fly() {
  int event = event_none;
  for (int i = 0; i < trace.limits.z && event == event_none; ++i) {
    vec3 p = path.origin + path.t * path.direction;
    Bound bound = cloud_ahead(p);
    AirAhead air = air_ahead(p);
    vec3 u = random_numbers();
    float cloud_per_m = bound.density * cloud.medium.x;
    float per_m = max(cloud_per_m + air.per_m, 1.0e-20);
    float flight_m = sample_optical_depth(u.x) / per_m;
    float free_m = onward_m(min(bound.free_m, air.free_m));
    path.t += min(flight_m, free_m);
    bool in_gap = path.t > path.gap_begin && path.t < path.gap_end;
    float kind = u.y * per_m;
    if (path.t >= path.end_m) event = event_arrival;
    else if (flight_m >= free_m) path.t = path.mode == mode_sunlight ? after_gap(path.t) : path.t;
    else if (kind >= cloud_per_m) pass_air(air.per_m, u.z);
    else if (path.t < kept.flight.z && !in_gap) event = meet_cloud(bound.density, kind / cloud_per_m, u.z);
    ++flights;
  }
  return event;
}

// What a flight of the path ends in: where the air turns it, or the end itself. What is first seen, cloud or ground, is as far as it is
// without the air.
int settled(int event) {
  if (event == event_none || path.mode != mode_flight) return event;
  bool escapes = event == event_arrival && path.surface_m >= no_hit_m;
  first_event = kept.flight.w == 0.0;
  kept.flight.w = 1.0;
  if (first_event && !escapes) path.first_m = event == event_collision ? max(path.t, 1.0e-3) : -max(path.surface_m, 1.0e-3);
  if (first_event && escapes && planet_distance_m(path.origin, path.direction) >= no_hit_m)
    path.radiance += path.throughput * radiance_of_space(path.direction);
  float rest = escapes ? 0.0 : mean_of(path.throughput);
  float whole = kept.flight.x + rest;
  bool in_air = random_numbers().x * whole < kept.flight.x;
  path.throughput *= rest > 0.0 ? whole / rest : 0.0;
  if (!in_air) return event;
  path.throughput = whole * kept.colours_t.xyz;
  path.t = kept.colours_t.w;
  return event_in_air;
}

// Rayleigh or aerosol: both for the sun, one of them for where the path goes on.
Vertex scatter_in_air() {
  vec3 u = random_numbers();
  vec3 v = random_numbers();
  float g = frame.aerosol.x;
  vec3 position = path.origin + path.t * path.direction;
  AirAt air = air_at(altitude_far_of(position), frame_atmosphere());
  vec3 rayleigh = air.rayleigh / max(air.rayleigh + vec3(air.aerosol), vec3(1.0e-30));
  Sunlight sun = sunlight_at(position, u.x, u.y);
  float to_sun = dot(path.direction, sun.direction);
  vec3 phase = mix(vec3(phase_cornette_shanks(to_sun, g)), vec3(phase_rayleigh(to_sun)), rayleigh);
  path.sunlight = path.throughput * phase * sun.irradiance;
  float share = dot(path.throughput, rayleigh) / max(dot(path.throughput, vec3(1.0)), 1.0e-30);
  bool even = u.z < share;
  path.throughput *= even ? rayleigh / share : (1.0 - rayleigh) / (1.0 - share);
  float cosine = even ? sample_rayleigh(v.x) : sample_henyey_greenstein(g, v.x);
  if (!even) path.throughput *= 1.5 * (1.0 + cosine * cosine) / (2.0 + g * g);  // Cornette and Shanks over Henyey and Greenstein
  path.next_direction = direction_about(path.direction, 0.5 - 0.5 * cosine, v.y);
  roulette(v.z);
  return Vertex(position, sun.direction);
}
#endif
