// The cells of render/sun_density.comp, for what is marched through them. Each invocation is of a point of a volume like the cells': in
// the middle of them across, and from the lowest cloud (the first layer) to the highest (the last); levels of the threshold one above
// the other.
#include "shared/sun_block.glsl"
#include "render/sun_path.glsl"
layout(binding = 0) uniform sampler3D sun_density;

struct GridPoint {
  vec3 place;  // as render/sun_path.glsl has it
  float level;
};

// `size`: of the volume's texture.
bool is_in_grid(ivec3 texel, ivec3 size) { return all(lessThan(texel.xy, size.xy)) && texel.z < volume_pass.z_end; }

GridPoint grid_point(ivec3 texel, ivec3 size) {
  int layers = size.z / sun_grid.size.w;
  int level = texel.z / layers;
  float up = float(texel.z - level * layers) / float(layers - 1);
  vec2 across = (vec2(texel.xy) + 0.5) / vec2(size.xy);
  return GridPoint(vec3(across, mix(sun_grid.levels.z, sun_grid.levels.w, up)), float(level));
}

float grid_density(vec3 place, float level) {
  float layers = float(sun_grid.size.z);
  float up = (place.z - sun_grid.levels.z) / (sun_grid.levels.w - sun_grid.levels.z) * layers;
  float row = level * layers + clamp(up, 0.5, layers - 0.5);
  return textureLod(sun_density, vec3(place.xy, row / (layers * float(sun_grid.size.w))), 0.0).x;
}

// How many cells a way from a place spans, along the axis with the most of them.
float cells_between(vec3 from, vec3 to) {
  vec3 cells = (to - from) * vec3(sun_grid.size.xy, float(sun_grid.size.z) / (sun_grid.levels.w - sun_grid.levels.z));
  return max(length(cells.xy), abs(cells.z));
}
