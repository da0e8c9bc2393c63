// Radiance to display values: tone curves and the sRGB transfer function.
#ifndef LIB_DISPLAY
#define LIB_DISPLAY

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }  // Rec. 709

// IEC 61966-2-1, exact.
float srgb_from_linear(float x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}
vec3 srgb_from_linear3(vec3 c) { return vec3(srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z)); }

// L / (1 + L) on luminance (Olajos 2.7); what still exceeds 1 in a channel is bent towards white at equal luminance.
vec3 tone_reinhard(vec3 color) {
  float l = luminance(color);
  vec3 mapped = color / (1.0 + l);
  float peak = max(mapped.x, max(mapped.y, mapped.z));
  float target = l / (1.0 + l);
  return peak > 1.0 ? vec3(target) + (mapped - vec3(target)) * ((1.0 - target) / (peak - target)) : mapped;
}

// Stephen Hill's fit of the ACES reference and output transforms (BakingLab).
vec3 tone_aces(vec3 color) {
  vec3 v = vec3(dot(vec3(0.59719, 0.35458, 0.04823), color), dot(vec3(0.07600, 0.90834, 0.01566), color),
                dot(vec3(0.02840, 0.13383, 0.83777), color));
  vec3 fitted = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  vec3 o = vec3(dot(vec3(1.60475, -0.53108, -0.07367), fitted), dot(vec3(-0.10208, 1.10813, -0.00605), fitted),
                dot(vec3(-0.00327, -0.07276, 1.07602), fitted));
  return clamp(o, 0.0, 1.0);
}

// AgX (Troy Sobotka), the minimal form by Benjamin Wrensch: log2 over -12.47393..4.026069 EV, a fitted sigmoid. The result is
// already display-encoded: no sRGB transfer function after it.
vec3 tone_agx(vec3 color) {
  vec3 v = vec3(dot(vec3(0.842479062253094, 0.0784335999999992, 0.0792237451477643), color),
                dot(vec3(0.0423282422610123, 0.878468636469772, 0.0791661274605434), color),
                dot(vec3(0.0423756549057051, 0.0784336, 0.879142973793104), color));
  v = clamp((log2(max(v, vec3(1.0e-10))) + 12.47393) / (4.026069 + 12.47393), 0.0, 1.0);
  vec3 v2 = v * v;
  vec3 v4 = v2 * v2;
  v = 15.5 * v4 * v2 - 40.14 * v4 * v + 31.96 * v4 - 6.868 * v2 * v + 0.4298 * v2 + 0.1191 * v - 0.00232;
  vec3 o = vec3(dot(vec3(1.19687900512017, -0.0980208811401368, -0.0990297440797205), v),
                dot(vec3(-0.0528968517574562, 1.15190312990417, -0.0989611768448433), v),
                dot(vec3(-0.0529716355144438, -0.0980434501171241, 1.15107367264116), v));
  return clamp(o, 0.0, 1.0);
}

// Display-encoded values in 0..1; curve as core's ToneCurve.
vec3 display_from_radiance(vec3 radiance, float exposure, int curve) {
  vec3 color = max(radiance * exposure, vec3(0.0));
  if (curve == 0) return tone_agx(color);
  if (curve == 1) return srgb_from_linear3(tone_aces(color));
  if (curve == 2) return srgb_from_linear3(tone_reinhard(color));
  return srgb_from_linear3(clamp(color, 0.0, 1.0));
}
#endif
