// targets: r32f
// For each point of a terrain: tangent of the height at which the land stands towards the sun's azimuth. The shadows of one sun
// are looked up in it: soft, at any sun's elevation, for every camera. Exact: a cell is left out only if nothing in it can stand
// higher than what was found before.
#include "render/terrain_lattice.glsl"

const int most_cells = 256;
const float farthest_m = 300000.0;  // beyond it the planet hides every mountain

PassOutput shade(ivec2 pixel) {
  vec2 origin = vec2(pixel);
  float origin_m = max(lattice_point(pixel, 0).x, terrain.rock.w);  // or that of the water
  vec2 direction = lattice_direction(terrain.sun.xy);
  float end_m = farthest_m;
  if (terrain.size.z == 0) end_m = distance_to_exit(origin, vec2(0.0), float(terrain.size.x - 1), direction);
  float tangent = -0.2;
  float t = 0.75 * terrain.lattice.y;  // the slope of the point's own cell is the surface normal's affair
  float nudge = 1.0e-3 * terrain.lattice.y;
  int level = 0;
  for (int i = 0; i < most_cells && t < end_m; ++i) {
    float cell_points = float(1 << level);
    vec2 at = origin + direction * t;
    vec2 cell = floor(at / cell_points);
    float exit_m = t + distance_to_exit(at, cell, cell_points, direction);
    float rise_m = lattice_point(ivec2(cell), level).y - origin_m;
    float highest = rise_m / (rise_m > 0.0 ? t : exit_m) - t / (2.0 * planet_radius_m);
    if (highest > tangent && level > 0) {
      --level;
      continue;
    }
    if (highest > tangent) {
      vec4 corners = cell_corners(ivec2(cell), 0);
      for (int k = 1; k <= 2; ++k) {
        float s = mix(t, exit_m, 0.5 * float(k));
        float height_m = height_in_cell(corners, clamp(origin + direction * s - cell, 0.0, 1.0));
        tangent = max(tangent, (height_m - origin_m) / s - s / (2.0 * planet_radius_m));
      }
    } else {
      level = min(level + 1, terrain.size.y);
    }
    if ((terrain.altitude.y - terrain.altitude.x - origin_m) / t - t / (2.0 * planet_radius_m) <= tangent) break;
    t = exit_m + nudge + 1.0e-6 * exit_m;
  }
  return PassOutput(vec4(tangent));
}
