// The air as the sky tables have it: paths meet only clouds and ground; the air lies between the camera and the first of them, and
// where a path leaves, the sky is looked up.
#ifndef TRACE_AIR_TABLES
#define TRACE_AIR_TABLES
#include "trace/flight.glsl"
#include "trace/world.glsl"

const bool air_is_traced = false;
void load_air(uint slot) {}
void store_air(uint slot) {}
int settled(int event) { return event; }
Vertex scatter_in_air() { return Vertex(vec3(0.0), vec3(0.0)); }

void begin_path() { path.first_m = 0.0; }
bool is_first() { return path.first_m == 0.0; }

// The air between the camera and the first vertex; `sign`: of what is kept of its distance.
void see_through_air(float distance_m, float sign) {
  if (path.first_m != 0.0) return;
  Air air = air_to(path.direction, distance_m);
  path.radiance += air.in_scatter;
  path.throughput *= air.transmittance;
  path.first_m = sign * max(distance_m, 1.0e-3);
}

// By the sun, or at night the moon, on a plane normal to the beam, where nothing but the air is in the way.
Sunlight sunlight_at(vec3 p, float u, float turn) {
  return Sunlight(towards_disc(frame.light_direction, u, turn), light_at(altitude_of(p), dot(up_at(p), frame.light_direction.xyz)));
}

// What a path that leaves the world ends in; the discs are for the camera alone, for the sun has been looked for at every turn.
vec3 radiance_beyond(vec3 direction, bool first) {
  vec2 planet = intersect_altitude(vec3(0.0, 0.0, camera_altitude_m()), direction, 0.0);
  if (sky_kind() == sky_clear && planet.x <= planet.y && planet.y > 0.0) return air_to(direction, max(planet.x, 0.0)).in_scatter;
  return first ? radiance_above(direction) : sky_radiance(direction);
}

void leave_world() { path.radiance += path.throughput * radiance_beyond(path.direction, is_first()); }

void begin_flight(Stretch stretch) {
  path.t = stretch.begin;
  path.end_m = cloud.medium.x > 0.0 && path.transmittance > 0.0 ? min(stretch.end, path.surface_m) : -1.0;
}

// The ray goes on to its next event, for as many flights as a round has.
int fly() {
  int event = event_none;
  for (int i = 0; i < trace.limits.z && event == event_none; ++i) {
    vec3 p = path.origin + path.t * path.direction;
    Bound bound = density_bound(p, path.direction);
    vec3 u = random_numbers();
    float flight_m = sample_optical_depth(u.x) / max(bound.density * cloud.medium.x, 1.0e-20);
    float free_m = onward_m(bound.free_m);
    bool tentative = flight_m < free_m;
    path.t += min(flight_m, free_m);
    if (path.t >= path.end_m) event = event_arrival;
    else if (tentative) event = meet_cloud(bound.density, u.y, u.z);
    else path.t = after_gap(path.t);
    ++flights;
  }
  return event;
}
#endif
