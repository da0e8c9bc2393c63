// A surface of water: what it reflects and lets through, how steep its facets are, and its waves. Slopes are spread evenly over
// azimuths as a Gaussian with the mean square `mss` (Cox and Munk 1954, "Measurement of the Roughness of the Sea Surface from
// Photographs of the Sun's Glitter", whose crosswind and upwind slopes differ by a fifth from their mean).
#ifndef LIB_WATER
#define LIB_WATER
#include "lib/constants.glsl"

const float water_index = 1.333;  // of refraction, at 589 nm and 20 degrees C

// Share of unpolarized light that a smooth surface reflects where it arrives at this cosine to the normal; exact (Fresnel 1823).
float water_fresnel(float cosine) {
  float c = clamp(cosine, 0.0, 1.0);
  float g = sqrt(water_index * water_index - 1.0 + c * c);
  float across = (g - c) / (g + c);
  float along = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return 0.5 * across * across * (1.0 + along * along);
}

// Cosine to the normal of the light that goes on in the water.
float water_refracted(float cosine) { return sqrt(1.0 - (1.0 - cosine * cosine) / (water_index * water_index)); }

// How likely a slope with this square is, per unit of slope east and north.
float slope_density(float squared_slope, float mss) { return exp(-squared_slope / mss) / (pi * mss); }

// How much of the facets other facets hide, seen at a cosine to the vertical (Smith 1967, by the fit of Walter et al. 2007).
float hidden_ratio(float cosine, float mss) {
  float a = cosine / sqrt(max(mss * (1.0 - cosine * cosine), 1.0e-12));
  return a < 1.6 ? (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a) : 0.0;
}

// How much of a beam facets send towards `view`, which may be below the water; per unit of slope and of what they cover.
float facets_towards(vec3 view, vec3 light, vec3 up, float mss) {
  vec3 middle = normalize(view + light);
  float cos_tilt = dot(middle, up);
  if (cos_tilt <= 0.0) return 0.0;
  float square = cos_tilt * cos_tilt;
  vec3 away = middle - cos_tilt * up;
  return water_fresnel(dot(middle, view)) * slope_density(dot(away, away) / square, mss) / (square * square);
}

// Radiance that the facets reflect of a beam, for each unit of its irradiance on a plane normal to it, 1/sr. `view`, `light`:
// unit, towards the camera and the light; `up`: the mean normal. What a facet sends down is reflected once more, as by level water: in
// a low sun that is a fifth of the light.
float water_glitter(vec3 view, vec3 light, vec3 up, float mss) {
  float cos_view = dot(view, up);
  float cos_light = dot(light, up);
  if (cos_view <= 0.0 || cos_light <= 0.0) return 0.0;
  float twice = water_fresnel(cos_view) * facets_towards(view - 2.0 * cos_view * up, light, up, mss);
  float seen_and_lit = 1.0 / (1.0 + hidden_ratio(cos_view, mss) + hidden_ratio(cos_light, mss));
  return (facets_towards(view, light, up, mss) + twice) * seen_and_lit / (4.0 * cos_view);
}

// What the facets reflect on average: how much, from where (unit), and how far about it (radians, in the plane of incidence).
struct Mirrored {
  float share;
  vec3 direction;
  float spread;
};

// One facet, tilted by `slope` towards the camera, and its share by the area that the camera sees of it: direction times
// reflected share, and that share. What it reflects of the water is what the water reflects of the sky.
vec4 mirrored_facet(vec3 view, vec3 up, vec3 towards, float slope) {
  vec3 facet = normalize(up + slope * towards);
  float cosine = dot(view, facet);
  vec3 reflected = 2.0 * cosine * facet - view;
  reflected = reflected - 2.0 * min(0.0, dot(reflected, up)) * up;
  float share = water_fresnel(cosine);
  return vec4(share * reflected, share);
}

// Over the slopes in the plane of incidence by Gauss-Hermite quadrature of five points; those across it change little. The share is right to
// 6 % up to a wind of 5 m/s, to 12 % at 11 m/s.
Mirrored water_mirror(vec3 view, vec3 up, float mss) {
  float cosine = max(dot(view, up), 1.0e-4);
  vec3 level = view - cosine * up;
  float sine = length(level);
  vec3 towards = sine > 1.0e-4 ? level / sine : vec3(0.0);
  float root = sqrt(mss);
  vec4 sum = vec4(0.0);
  float seen = 0.0;
  for (int i = -2; i <= 2; ++i) {
    int place = i < 0 ? -i : i;
    float slope = root * (place == 0 ? 0.0 : place == 1 ? 0.9585724646 : 2.0201828705) * (i < 0 ? -1.0 : 1.0);
    float weight = place == 0 ? 0.5333333333 : place == 1 ? 0.2220759220 : 0.0112574113;
    weight *= max(0.0, cosine + slope * sine);
    seen += weight;
    sum += weight * mirrored_facet(view, up, towards, slope);
  }
  vec3 mean = vec3(sum.x, sum.y, sum.z) / max(sum.w, 1.0e-9);
  float length_of_mean = min(length(mean), 1.0);
  return Mirrored(sum.w / max(seen, 1.0e-9), mean / max(length_of_mean, 1.0e-6), sqrt(2.0 * (1.0 - length_of_mean)));
}

// Waves on a part of the surface: their slope, the mean square slope that is finer than a pixel or left out, and from where
// the water has been carried (Gerstner 1802): what makes crests sharp and troughs wide.
struct Waves {
  vec2 slope;
  float unseen_mss;
  vec2 carried_m;
};

// The part of the surface that a pixel covers: its middle, the way of the view ray across the surface (unit), and how wide it is
// along and across it, m.
struct Footprint {
  vec2 middle_m;
  vec2 along;
  float along_m, across_m;
};

// cos(2 pi turns) to a thousandth, by two parabolas: a software rasterizer has no quicker one.
vec4 quick_cosine(vec4 turns) {
  vec4 x = fract(turns + 0.75) - 0.5;
  vec4 y = x * (8.0 - 16.0 * abs(x));
  return y * (0.775 + 0.225 * abs(y));
}

// Adds four trains of waves, all of whose slopes are at most `slope`. Columns: direction east, north; wave number (1/m); phase at the
// origin (turns). Each train is carried by the longer ones before it. A train's slope averaged over the footprint is less: about as over
// a Gaussian of half its width, and none from where that is three quarters of a wave.
Waves add_waves(Waves waves, mat4 trains, float slope, Footprint footprint) {
  vec4 along = (trains[0] * footprint.along.x + trains[1] * footprint.along.y) * footprint.along_m;
  vec4 across = (trains[1] * footprint.along.x - trains[0] * footprint.along.y) * footprint.across_m;
  vec4 left = max(1.0 - 0.05 * trains[2] * trains[2] * (along * along + across * across), vec4(0.0));
  vec4 kept = slope * left * left;
  vec2 at = footprint.middle_m + waves.carried_m;
  vec4 turns = (trains[0] * at.x + trains[1] * at.y) * trains[2] * (0.5 / pi) + trains[3];
  vec4 steep = kept * quick_cosine(turns);
  vec4 carried = steep / trains[2];
  waves.slope += vec2(dot(steep, trains[0]), dot(steep, trains[1]));
  waves.carried_m -= vec2(dot(carried, trains[0]), dot(carried, trains[1]));
  waves.unseen_mss += 0.5 * (4.0 * slope * slope - dot(kept, kept));
  return waves;
}
#endif
