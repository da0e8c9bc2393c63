// Cloud forming: what turns noise into clouds (Olajos 2.3).
#ifndef LIB_SHAPE
#define LIB_SHAPE

// HD(h) = (1 - exp(-a h)) exp(-b h), h in 0..1 from the bottom to the top of the volume (Olajos 2.3.1).
float height_distribution(float h, float a, float b) { return (1.0 - exp(-a * h)) * exp(-b * h); }

// 1 inside the tile, falling smoothly to 0 at its edges, so that what it multiplies still tiles.
float tile_window(vec2 tile) {
  float margin = min(min(tile.x, 1.0 - tile.x), min(tile.y, 1.0 - tile.y));
  return smoothstep(0.0, 0.08, margin);  // tuned: wide enough for no visible wall, narrow enough to leave room for towers
}

// A Gaussian tower: what it adds to the shape noise at `tile` (0..1) and height h (Olajos 2.3.2). The bell's surface stands at
// top * exp(-d^2 / (2 r^2)); below it the tower is solid, above it fades over a fifth of the volume's height.
float tower_offset(vec2 tile, float h, vec2 center, float radius, float top, float strength) {
  vec2 d = tile - center;
  float bell = exp(-dot(d, d) / (2.0 * radius * radius));
  float below = clamp((top * bell - h) / 0.2, 0.0, 1.0);
  float base = 1.0 - exp(-50.0 * h);  // flat base, as HD's default
  return strength * bell * below * base * tile_window(tile);
}

// The shape with finer noises mixed in by their weights: thicker where they are above their mean, thinner where below.
float mixed_shape(float shape, vec3 finer, vec3 weights) { return shape * (1.0 + dot(weights, finer - vec3(0.5))); }

// Spreads [low, high] over [0, 1].
float stretch(float value, float low, float high) { return clamp((value - low) / (high - low), 0.0, 1.0); }
#endif
