// targets: rgba16f rg32f
// Averages each pixel of a single-sample march with its eight neighbours: the jitter of the first step is spread over 3x3 pixels
// (lib/hash.glsl), so that their mean is nearly free of it. For moving pictures, which have no time to gather samples.
layout(binding = 0) uniform sampler2D march_radiance;
layout(binding = 1) uniform sampler2D march_depth;

PassOutput shade(ivec2 pixel) {
  ivec2 last = textureSize(march_radiance, 0) - 1;
  vec4 radiance = vec4(0.0);
  float visibility = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), last);
      radiance += texelFetch(march_radiance, at, 0);
      visibility += texelFetch(march_depth, at, 0).y;
    }
  }
  float distance_m = texelFetch(march_depth, pixel, 0).x;
  return PassOutput(radiance / 9.0, vec4(distance_m, visibility / 9.0, 0.0, 0.0));
}
