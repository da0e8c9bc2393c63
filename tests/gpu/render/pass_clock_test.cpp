// Frames tell what each of their passes took, if they are asked.
#include <gmock/gmock.h>

#include "fixture.h"

namespace cloudscape::render {
namespace {

using PassClockTest = RenderTest;

FrameRequest timed(int reuse) {
  FrameRequest request = picture(small_clouds(), {{0, 0, 500}, 20, 12, 0}, {320, 180});
  request.content = FrameContent::display;
  request.quality = render_quality(Quality::interactive);
  request.quality.samples = 2, request.quality.smooth = false;
  request.quality.reuse = reuse;
  request.display.bloom_strength = 0.1;
  request.time_passes = true;
  return request;
}

std::vector<std::string> names_of(const Frame& frame) {
  std::vector<std::string> names;
  for (const PassTime& pass : frame.timings.passes) names.push_back(pass.name);
  return names;
}

TEST_F(PassClockTest, every_pass_is_named_once_in_its_order) {
  EXPECT_THAT(names_of(render(timed(1))),
              testing::ElementsAre("sky", "scene", "march", "composite", "bloom", "tone_map", "read_back"));
  EXPECT_THAT(names_of(render(timed(4))), testing::ElementsAre("sky", "scene", "march", "composite", "even", "resolve",
                                                               "bloom", "develop", "read_back"));
}

TEST_F(PassClockTest, passes_add_up_to_the_frame) {
  render(timed(1));  // bakes, and compiles
  const Frame frame = render(timed(1));
  double sum_ms = 0, sum_cpu_ms = 0;
  for (const PassTime& pass : frame.timings.passes) {
    EXPECT_GT(pass.ms, 0) << pass.name;
    sum_ms += pass.ms, sum_cpu_ms += pass.cpu_ms;
  }
  // A GPU's own time; software works while the renderer waits.
  const double whole_ms = stack().context.device().software ? frame.timings.render_ms : frame.timings.gpu_ms;
  EXPECT_LE(sum_ms, 1.3 * whole_ms);  // a GPU's timer stops before the picture is on its way back
  EXPECT_GT(sum_ms, 0.7 * whole_ms);
  EXPECT_EQ(sum_cpu_ms > 0, stack().context.device().software);
}

TEST_F(PassClockTest, nothing_is_told_unasked) {
  FrameRequest request = timed(4);
  request.time_passes = false;
  EXPECT_TRUE(render(request).timings.passes.empty());
}

TEST_F(PassClockTest, the_clock_changes_no_picture) {
  const FrameRequest asked = timed(1);
  FrameRequest unasked = asked;
  unasked.time_passes = false;
  EXPECT_EQ(render(asked).display_rgba, render(unasked).display_rgba);
}

}  // namespace
}  // namespace cloudscape::render
