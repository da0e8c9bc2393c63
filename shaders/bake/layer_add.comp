// Adds a layer to the volume of all of them. Red: the union of their clouds, as the greatest of what each layer's shape is above its own
// threshold, plus the common threshold. Green: the density of the layer that is there.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/bake_block.glsl"
layout(binding = 0, rg16f) uniform image3D target;
layout(binding = 0) uniform sampler3D layer_shape;

const float common_threshold = 0.5;  // server/bake/baked_cloudscape.h
const float clear = -0.45;           // as low as clear air within a layer can be
// As high as it is beyond the layer: below all that erosion and the land's variation can take off the threshold. It goes on to fall there
// by so much for each height of the volume, so that each place knows which layer is nearest.
const float beyond_layer = -1.45;
const float fall_beyond = 2.0;
// tuned: where layers meet, the density goes from the one's to the other's while the one's shape outgrows the other's by so much: over
// some texels of cloud.
const float blend = 0.05;

// Of this layer alone: above 0 in its clouds. Beyond its bottom and top there are none.
float above_threshold(ivec3 texel) {
  int slice = texel.z - bake.slices.x;
  float height = (float(texel.z) + 0.5) / float(bake.size.z);
  float beyond = max(max(bake.layer.x - height, height - bake.layer.y), 0.0);
  if (slice < 0 || slice >= bake.slices.y) return beyond_layer - fall_beyond * beyond;
  return max(texelFetch(layer_shape, ivec3(texel.xy, slice), 0).x - bake.layer.z, clear);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (texel.z >= volume_pass.z_end) return;  // to be added once
  float shape = common_threshold + above_threshold(texel);
  vec2 sum = vec2(shape, bake.layer.w);
  if (bake.slices.w == 0) {
    vec2 before = imageLoad(target, texel).xy;
    sum = vec2(max(before.x, shape), mix(before.y, bake.layer.w, smoothstep(-blend, blend, shape - before.x)));
  }
  imageStore(target, texel, vec4(sum, 0.0, 0.0));
}
