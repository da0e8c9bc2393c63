// Takes every path of a list some events further (Novak et al. 2018, "Monte Carlo Methods for Volumetric Light Transport Simulation"):
// delta tracking through the medium; at each vertex a ray towards a point of the sun's disc, by ratio tracking; scattering by the
// phase function; the sky where a path leaves; a diffuse ground. Paths end by leaving, or by Russian roulette on their throughput.
//
// The state outlives the dispatch, so that no path is ever cut short and a dispatch is short. What is drawn depends on pixel, sample
// and seed alone.
#include "trace/state.glsl"
#include "trace/bounds.glsl"
#include "trace/scattering.glsl"
#include "trace/sums.glsl"
#include "trace/world.glsl"

const int event_none = 0;
const int event_collision = 1;  // of the path with a particle
const int event_arrival = 2;    // where the medium ends, or at a surface, or the ray towards the sun is dark
const float weak_throughput = 0.25;  // tuned: roulette from here on; more ends paths that still bring light, less wastes time
const float weak_transmittance = 0.1;

uint flights = 0u;
uint above_majorant = 0u;

float after_gap(float t) { return t > path.gap_begin && t < path.gap_end ? path.gap_end : t; }

// The ray goes on to its next event, for as many flights as a round has.
int fly() {
  int event = event_none;
  for (int i = 0; i < trace.limits.z && event == event_none; ++i) {
    vec3 p = path.origin + path.t * path.direction;
    Bound bound = density_bound(p, path.direction);
    vec3 u = random_numbers();
    float flight_m = sample_optical_depth(u.x) / max(bound.density * cloud.medium.x, 1.0e-20);
    bool tentative = flight_m < bound.free_m;
    path.t += min(flight_m, bound.free_m);
    if (path.t >= path.end_m) {
      event = event_arrival;
    } else if (tentative) {
      float ratio = density_at(path.origin + path.t * path.direction) / bound.density;
      if (ratio > 1.0001) ++above_majorant;
      if (path.mode == mode_sunlight) {
        path.transmittance *= max(0.0, 1.0 - ratio);
        if (path.transmittance < weak_transmittance)
          path.transmittance = u.z * weak_transmittance < path.transmittance ? weak_transmittance : 0.0;
        if (path.transmittance <= 0.0) event = event_arrival;
      } else if (u.y < ratio) {
        event = event_collision;
      }
    } else {
      path.t = after_gap(path.t);
    }
    ++flights;
  }
  return event;
}

// A ray from `origin`. One towards the sun that meets the ground is dark.
void begin_ray(vec3 origin, vec3 direction, uint mode) {
  Stretch stretch = traced_stretch(origin, direction);
  path.surface_m = surface_distance_m(origin, direction);
  path.origin = origin, path.direction = direction, path.mode = mode;
  path.transmittance = mode == mode_sunlight && path.surface_m < no_hit_m ? 0.0 : 1.0;
  path.gap_begin = stretch.gap_begin, path.gap_end = stretch.gap_end;
  path.t = stretch.begin;
  path.end_m = cloud.medium.x > 0.0 && path.transmittance > 0.0 ? min(stretch.end, path.surface_m) : -1.0;
}

void roulette(float u) {
  float strength = greatest(path.throughput) / weak_throughput;
  if (strength < 1.0) path.throughput = u < strength ? path.throughput / strength : vec3(0.0);
}

// The air between the camera and the first vertex; `sign`: of what is kept of its distance.
void see_through_air(float distance_m, float sign) {
  if (path.first_m != 0.0) return;
  Air air = air_to(path.direction, distance_m);
  path.radiance += air.in_scatter;
  path.throughput *= air.transmittance;
  path.first_m = sign * max(distance_m, 1.0e-3);
}

// Where a path turns, and towards which point of the sun it looks. What the sun adds and where the path goes on stand in `path`.
struct Vertex {
  vec3 position, sun;
};

Vertex scatter() {
  see_through_air(path.t, 1.0);
  vec3 u = random_numbers();
  Vertex vertex = Vertex(path.origin + path.t * path.direction, towards_sun(u.x, u.y));
  ++path.order;
  path.throughput *= cloud.medium.y / cloud.medium.x;
  path.sunlight = path.throughput * phase_value(path.direction, vertex.sun) * sun_irradiance_at(vertex.position);
  Scattered scattered = scattered_from(path.direction);
  path.next_direction = scattered.direction;
  path.hue *= scattered.likelihood;
  float mean = (path.hue.x + path.hue.y + path.hue.z) / 3.0;
  path.hue /= mean;
  path.throughput *= scattered.weight / mean;
  roulette(u.z);
  return vertex;
}

Vertex bounce() {
  vec3 u = random_numbers();
  vec3 v = random_numbers();
  Reflector surface = surface_at(path.origin, path.direction, path.surface_m, path.first_m == 0.0);
  see_through_air(path.surface_m, -1.0);
  Vertex vertex = Vertex(path.origin + path.surface_m * path.direction + off_the_ground_m * surface.normal, towards_sun(u.x, u.y));
  path.throughput *= surface.albedo;
  float cosine = max(0.0, dot(surface.normal, vertex.sun));
  path.sunlight = path.throughput * (cosine / pi) * sun_irradiance_at(vertex.position);
  path.next_direction = sample_cosine(surface.normal, v.x, v.y);
  roulette(u.z);
  return vertex;
}

void leave_world() {
  path.radiance += path.throughput * radiance_beyond(path.direction, path.first_m == 0.0);
}

// The camera's ray of the pixel's next sample.
CameraRay begin_sample() {
  uvec3 key = pcg3d(uvec3(path.pixel, path.sample_number, trace.seed.x));
  path.key = key.xy, path.colour = key.z % 3u, path.drawn = 0u;
  vec2 pixel = vec2(int(path.pixel) % frame.size.x, int(path.pixel) / frame.size.x);
  CameraRay ray = camera_ray(pixel + random_numbers().xy);
  path.throughput = vec3(ray.valid);
  path.radiance = vec3(0.0), path.sunlight = vec3(0.0), path.hue = vec3(1.0);
  path.first_m = 0.0, path.order = 0u;
  return ray;
}

// What an event brings, and then the next ray or the end of the sample.
void go_on(int event) {
  bool ends = false;
  Vertex vertex = Vertex(path.origin, vec3(0.0));
  if (path.mode == mode_sunlight) {
    path.radiance += path.sunlight * path.transmittance;
    path.sunlight = vec3(0.0);
  } else if (event == event_collision) {
    ends = trace.limits.x > 0 && int(path.order) >= trace.limits.x;
    if (!ends) vertex = scatter();
  } else if (path.mode == mode_flight) {
    ends = path.surface_m >= no_hit_m;
    if (ends) leave_world();
    else vertex = bounce();
  }
  bool lit = !ends && greatest(path.sunlight) > 0.0;
  if (path.mode != mode_new && (ends || (!lit && greatest(path.throughput) <= 0.0))) end_sample();
  CameraRay ray = CameraRay(vertex.position, lit ? vertex.sun : path.next_direction, 1.0);
  bool first = path.mode == mode_new;
  if (first) ray = begin_sample();
  if (path.mode != mode_idle) begin_ray(ray.origin, ray.direction, lit && !first ? mode_sunlight : mode_flight);
  if (ray.valid == 0.0) path.end_m = -1.0, path.surface_m = no_hit_m;
}

void main() {
  if (gl_GlobalInvocationID.x >= uint(trace.work.y)) return;
  uint slot = list_now[uint(trace.work.x) + gl_GlobalInvocationID.x];
  load_path(slot);
  if (path.mode == mode_idle) {
    path.pixel = atomicAdd(counters.next_pixel, 1u);
    if (path.pixel >= uint(trace.work.z)) return;
    path.sample_number = trace.seed.y, path.mode = mode_new, path.t = 0.0, path.end_m = -1.0;
  }
  for (int round = 0; round < trace.limits.y && path.mode != mode_idle; ++round) {
    int event = fly();
    if (event != event_none) go_on(event);
  }
  if (done.samples > 0.0) add_done_samples();
  store_path(slot);
  list_next[atomicAdd(counters.listed, 1u)] = slot;
  atomicAdd(counters.flights, flights);
  if (above_majorant > 0u) atomicAdd(counters.above_majorant, above_majorant);
}
