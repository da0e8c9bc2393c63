// The medium and how it is marched (server/render fills it). Binding 2.
#ifndef SHARED_CLOUD_BLOCK
#define SHARED_CLOUD_BLOCK
#include "shared/block.glsl"

/* layer: bottom altitude, top altitude, 1 / thickness, kind as core's VolumeKind (vdb for all that comes from a file).
   tile: 1 / size east, 1 / size north (1/m), offset east, north (tiles) of the point below the camera.
   box_low, box_high: corners of the volume relative to the point below the camera (not curved), w of low: tiles?, of high: 0.
   volume: longest small step (m), bent with the planet?, cloud cover (0..1), several layers?
   shape: threshold, edge softness, variation amount, shift of the tile by the variation (tiles).
   weights: of the four shape channels. variation: 1 / period (1/m), offset east, north (periods), 0.
   detail, fine_detail: 1 / period (1/m), offset east, north, up (periods). lean: of the layer's top against its bottom east, north (m), 0, 0. erosion: strength, sample spacing from which it is averaged (m), the same for its finest part;
   change of the shape for each metre between samples (1/m).
   medium: extinction (1/m), scattering (1/m), ambient scale, phase kind. phase: g, second g, second weight, light model.
   olajos: attenuation, in-scatter, gain, 0.
   octave_weight_low/high, octave_extinction_low/high, octave_asymmetry_low/high: of octaves 0..3 and 4..7; weight 0: unused.
   steps: small step (m), least share of the distance, greatest number, light steps. adaptive: begin (m), growth of the small step for each
   metre beyond it, random first step?, lighting? structure: large step (m; 0: none), slack of the threshold, what is free
   of cloud about a point outside, about one in its outer padding (m). distance: factor on the distance field (0: none), threshold of its
   lowest level, levels for each unit of threshold, levels.
   in_scatter_scale, in_scatter_offset: from a place in the volume (0..1) to one in the in-scatter volume; of scale w: levels, one
   above the other, of offset w: mean cosine of the phase function. in_scatter_levels: threshold of the lowest level, levels for each
   unit of threshold, share of extinction that is scattering into the forward peak, how strongly the fine optical depth shades.
   olajos_dark, olajos_bright: rgb. march: how far the light is marched (m), view distance (m), altitudes between which there is cloud (m). */
#define CLOUD_FIELDS(F) \
  F(vec4, layer) \
  F(vec4, tile) \
  F(vec4, box_low) \
  F(vec4, box_high) \
  F(vec4, volume) \
  F(vec4, shape) \
  F(vec4, weights) \
  F(vec4, variation) \
  F(vec4, detail) \
  F(vec4, fine_detail) \
  F(vec4, lean) \
  F(vec4, erosion) \
  F(vec4, medium) \
  F(vec4, phase) \
  F(vec4, olajos) \
  F(vec4, octave_weight_low) \
  F(vec4, octave_weight_high) \
  F(vec4, octave_extinction_low) \
  F(vec4, octave_extinction_high) \
  F(vec4, octave_asymmetry_low) \
  F(vec4, octave_asymmetry_high) \
  F(vec4, steps) \
  F(vec4, march) \
  F(vec4, adaptive) \
  F(vec4, structure) \
  F(vec4, distance) \
  F(vec4, in_scatter_scale) \
  F(vec4, in_scatter_offset) \
  F(vec4, in_scatter_levels) \
  F(vec4, olajos_dark) \
  F(vec4, olajos_bright)
DECLARE_BLOCK(CloudBlock, cloud, 2, CLOUD_FIELDS)
#endif
