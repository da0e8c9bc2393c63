// A picture between its pixels by Catmull and Rom's cubic (1974), which keeps what is sharp, in five bilinear look-ups (the corners are
// left out: Jimenez 2016, "Filmic SMAA"), and never beyond what those find: no dark rims around what is bright.
#ifndef RENDER_CATMULL_ROM
#define RENDER_CATMULL_ROM

// `place`: 0..1 each; `size`: of the picture, which is sampled with linear interpolation, pixels.
vec4 catmull_rom(sampler2D picture, vec2 place, vec2 size) {
  vec2 at = place * size - 0.5;
  vec2 first = floor(at);
  vec2 f = at - first;
  vec2 before = f * (-0.5 + f * (1.0 - 0.5 * f));
  vec2 behind = f * f * (-0.5 + 0.5 * f);
  vec2 second = f * (0.5 + f * (2.0 - 1.5 * f));
  vec2 middle = 1.0 - before - behind;
  vec2 least = (first - 0.5) / size, most = (first + 2.5) / size;
  vec2 centre = (first + 0.5 + second / middle) / size;
  vec4 c = textureLod(picture, centre, 0.0);
  vec4 left = textureLod(picture, vec2(least.x, centre.y), 0.0), right = textureLod(picture, vec2(most.x, centre.y), 0.0);
  vec4 up = textureLod(picture, vec2(centre.x, least.y), 0.0), down = textureLod(picture, vec2(centre.x, most.y), 0.0);
  vec4 sum = middle.x * middle.y * c + middle.y * (before.x * left + behind.x * right) + middle.x * (before.y * up + behind.y * down);
  float weight = middle.x * middle.y + middle.y * (before.x + behind.x) + middle.x * (before.y + behind.y);
  return clamp(sum / weight, min(min(min(left, right), min(up, down)), c), max(max(max(left, right), max(up, down)), c));
}
#endif
