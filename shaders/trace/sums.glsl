// What each pixel's samples add up to. Sums are compensated (Kahan 1965), so that thousands of samples keep their digits.
#ifndef TRACE_SUMS
#define TRACE_SUMS
#include "shared/frame_block.glsl"
#include "trace/state.glsl"
layout(binding = 0, rgba32f) uniform image2D sums;          // of the samples' radiance; how many met the medium first
layout(binding = 1, rgba32f) uniform image2D lost;          // what rounding added to the sums; distances to the medium, m
layout(binding = 2, rgba32f) uniform image2D squares;       // of the squared radiance; distances to the ground, m
layout(binding = 3, rgba32f) uniform image2D lost_squares;  // as `lost`; how many met the ground first

// The samples that ended in this dispatch, of one pixel.
struct Done {
  vec3 sum, square;
  float medium, medium_m, ground, ground_m, samples;
};
Done done = Done(vec3(0.0), vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0);

void end_sample() {
  done.sum += path.radiance;
  done.square += path.radiance * path.radiance;
  done.samples += 1.0;
  if (path.first_m > 0.0) done.medium += 1.0, done.medium_m += path.first_m;
  if (path.first_m < 0.0) done.ground += 1.0, done.ground_m -= path.first_m;
  ++path.sample_number;
  path.mode = int(path.sample_number) < trace.work.w ? mode_new : mode_idle;
}

struct Compensated {
  vec3 sum, lost;
};

Compensated added(vec3 sum, vec3 lost_part, vec3 value) {
  precise vec3 corrected = value - lost_part;
  precise vec3 next = sum + corrected;
  precise vec3 rounding = (next - sum) - corrected;
  return Compensated(next, rounding);
}

void add_done_samples() {
  ivec2 pixel = ivec2(int(path.pixel) % frame.size.x, int(path.pixel) / frame.size.x);
  vec4 sum = imageLoad(sums, pixel);
  vec4 rest = imageLoad(lost, pixel);
  vec4 square = imageLoad(squares, pixel);
  vec4 square_rest = imageLoad(lost_squares, pixel);
  Compensated first = added(sum.xyz, rest.xyz, done.sum);
  Compensated second = added(square.xyz, square_rest.xyz, done.square);
  imageStore(sums, pixel, vec4(first.sum, sum.w + done.medium));
  imageStore(lost, pixel, vec4(first.lost, rest.w + done.medium_m));
  imageStore(squares, pixel, vec4(second.sum, square.w + done.ground_m));
  imageStore(lost_squares, pixel, vec4(second.lost, square_rest.w + done.ground));
  atomicAdd(counters.samples_done, uint(done.samples));
}
#endif
