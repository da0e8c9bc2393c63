// Takes every path of a list some events further (Novak et al. 2018, "Monte Carlo Methods for Volumetric Light Transport Simulation"):
// delta tracking through the medium; at each vertex a ray towards a point of the sun's disc, by ratio tracking; scattering by the
// phase function; the sky where a path leaves; a diffuse ground. Paths end by leaving, or by Russian roulette on their throughput.
//
// What is between the clouds is said by air_tables.glsl or air_traced.glsl.
//
// The state outlives the dispatch, so that no path is ever cut short and a dispatch is short. What is drawn depends on pixel, sample
// and seed alone.
#include "trace/flight.glsl"
#include "trace/scattering.glsl"
#include "trace/sums.glsl"

// A ray from `origin`. One towards the sun that meets the ground is dark.
void begin_ray(vec3 origin, vec3 direction, uint mode) {
  Stretch stretch = traced_stretch(origin, direction);
  path.surface_m = surface_distance_m(origin, direction);
  path.origin = origin, path.direction = direction, path.mode = mode;
  path.transmittance = mode == mode_sunlight && path.surface_m < no_hit_m ? 0.0 : 1.0;
  path.gap_begin = stretch.gap_begin, path.gap_end = stretch.gap_end;
  begin_flight(stretch);
}

Vertex scatter() {
  see_through_air(path.t, 1.0);
  vec3 u = random_numbers();
  vec3 position = path.origin + path.t * path.direction;
  Sunlight sun = sunlight_at(position, u.x, u.y);
  ++path.order;
  path.throughput *= cloud.medium.y / cloud.medium.x;
  path.sunlight = path.throughput * phase_value(path.direction, sun.direction) * sun.irradiance;
  if (path.order > 1u) sunlight_roulette(u.z, greatest(sun.irradiance));  // the path has the same number: each is right on average
  Scattered scattered = scattered_from(path.direction);
  path.next_direction = scattered.direction;
  path.hue *= scattered.likelihood;
  float mean = (path.hue.x + path.hue.y + path.hue.z) / 3.0;
  path.hue /= mean;
  path.throughput *= scattered.weight / mean;
  roulette(u.z);
  return Vertex(position, sun.direction);
}

Vertex bounce() {
  vec3 u = random_numbers();
  vec3 v = random_numbers();
  Reflector surface = surface_at(path.origin, path.direction, path.surface_m, is_first());
  see_through_air(path.surface_m, -1.0);
  vec3 position = path.origin + path.surface_m * path.direction + off_the_ground_m * surface.normal;
  Sunlight sun = sunlight_at(position, u.x, u.y);
  path.throughput *= surface.albedo;
  float cosine = max(0.0, dot(surface.normal, sun.direction));
  path.sunlight = path.throughput * (cosine / pi) * sun.irradiance;
  path.next_direction = sample_cosine(surface.normal, v.x, v.y);
  roulette(u.z);
  return Vertex(position, sun.direction);
}

// The camera's ray of the pixel's next sample.
CameraRay begin_sample() {
  uvec3 key = pcg3d(uvec3(path.pixel, path.sample_number, trace.seed.x));
  path.key = key.xy, path.colour = key.z % 3u, path.drawn = 0u;
  vec2 pixel = vec2(int(path.pixel) % frame.size.x, int(path.pixel) / frame.size.x);
  CameraRay ray = camera_ray(pixel + random_numbers().xy);
  path.throughput = vec3(ray.valid);
  path.radiance = vec3(0.0), path.sunlight = vec3(0.0), path.hue = vec3(1.0);
  path.order = 0u;
  begin_path();
  return ray;
}

// What an event brings, and then the next ray or the end of the sample.
void go_on(int event) {
  bool ends = false;
  event = settled(event);
  Vertex vertex = Vertex(path.origin, vec3(0.0));
  if (path.mode == mode_sunlight) {
    path.radiance += path.sunlight * path.transmittance;
    path.sunlight = vec3(0.0);
  } else if (event == event_collision) {
    ends = trace.limits.x > 0 && int(path.order) >= trace.limits.x;
    if (!ends) vertex = scatter();
  } else if (air_is_traced && event == event_in_air) {
    vertex = scatter_in_air();
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
  load_air(slot);
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
  store_air(slot);
  list_next[atomicAdd(counters.listed, 1u)] = slot;
  atomicAdd(counters.flights, flights);
  if (above_majorant > 0u) atomicAdd(counters.above_majorant, above_majorant);
}
