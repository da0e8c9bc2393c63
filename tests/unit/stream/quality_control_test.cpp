// What moving frames cost follows the render time and the link: soon, and without pumping.
#include "stream/quality_control.h"

#include <gtest/gtest.h>

#include <random>

namespace cloudscape::stream {
namespace {

constexpr double target_ms = 50;

// A frame costs a part that every frame pays and a part that follows the marched pixels.
struct Cost {
  double fixed_ms, marched_ms;
  double of(int divisor) const { return fixed_ms + marched_ms / (divisor * divisor); }
};

struct March {
  MarchControl control{target_ms};
  int changes = 0;
  std::mt19937 random{1};

  void frames(int count, const Cost& cost, double noise = 0) {
    std::uniform_real_distribution<double> factor(1 - noise, 1 + noise);
    for (int i = 0; i < count; ++i) {
      const int divisor = control.divisor();
      control.rendered(divisor, cost.of(divisor) * factor(random));
      changes += control.divisor() != divisor;
    }
  }
};

TEST(MarchControlTest, converges_within_ten_frames_of_a_step_up_and_of_a_step_down) {
  const Cost light{3, 20}, heavy{3, 300};
  March march;
  march.frames(50, light);
  EXPECT_EQ(march.changes, 0);
  march.frames(4, heavy);
  EXPECT_EQ(march.control.divisor(), 3) << "coarser is a matter of a few frames";
  EXPECT_LE(heavy.of(3), target_ms);
  march.frames(10, light);
  EXPECT_EQ(march.control.divisor(), 1);
  march.changes = 0;
  march.frames(500, light);
  EXPECT_EQ(march.changes, 0);
}

TEST(MarchControlTest, one_slow_frame_changes_nothing) {
  March march;
  march.frames(10, {3, 20});
  march.frames(1, {3, 900});
  march.frames(10, {3, 20});
  EXPECT_EQ(march.changes, 0);
}

TEST(MarchControlTest, hopeless_load_stays_coarsest) {
  March march;
  march.frames(100, {500, 5000});
  EXPECT_EQ(march.control.divisor(), 4);
  EXPECT_EQ(march.changes, 1);
}

TEST(MarchControlTest, noise_about_the_target_does_not_pump) {
  for (const Cost cost : {Cost{0, 48}, Cost{0, 70}, Cost{0, 110}, Cost{10, 60}, Cost{20, 200}, Cost{40, 30}}) {
    March march;
    march.frames(50, cost, 0.1);
    march.changes = 0;
    march.frames(500, cost, 0.1);
    EXPECT_LE(march.changes, 6) << cost.fixed_ms << " + " << cost.marched_ms;
    EXPECT_LE(cost.of(march.control.divisor()), 1.2 * target_ms);
  }
}

TEST(MarchControlTest, fixed_cost_does_not_leave_the_picture_coarse_after_a_spike) {
  const Cost cost{10, 25};
  March march;
  march.frames(10, cost);
  march.frames(3, {10, 900});
  EXPECT_GT(march.control.divisor(), 1);
  march.frames(40, cost);
  EXPECT_EQ(march.control.divisor(), 1);
}

TEST(MarchControlTest, frame_of_another_divisor_tells_nothing) {
  MarchControl control(target_ms);
  for (int i = 0; i < 10; ++i) control.rendered(2, 1000);
  EXPECT_EQ(control.divisor(), 1);
}

TEST(JpegControlTest, clear_way_raises_the_quality_slowly_to_its_bound) {
  JpegControl control(target_ms);
  EXPECT_EQ(control.quality(), 78);
  for (int i = 0; i < 10; ++i) control.acknowledged(0, 20);
  EXPECT_LE(control.quality(), 80);
  for (int i = 0; i < 200; ++i) control.acknowledged(0, 20);
  EXPECT_EQ(control.quality(), 85);
}

TEST(JpegControlTest, queue_lowers_it_within_ten_acknowledgements_to_its_bound) {
  JpegControl control(target_ms);
  for (int i = 0; i < 10; ++i) control.acknowledged(200, 150);
  EXPECT_EQ(control.quality(), 55);
  for (int i = 0; i < 10; ++i) control.dropped();
  EXPECT_EQ(control.quality(), 55);
}

TEST(JpegControlTest, frames_under_way_do_not_lower_it_a_second_time) {
  JpegControl control(target_ms);
  while (control.quality() == 78) control.acknowledged(100, 100);
  const int lowered = control.quality();
  for (int i = 0; i < 3; ++i) control.acknowledged(100, 100);
  EXPECT_EQ(control.quality(), lowered);
  control.acknowledged(100, 100);
  EXPECT_LT(control.quality(), lowered);
}

TEST(JpegControlTest, one_late_acknowledgement_and_a_middling_queue_change_nothing) {
  JpegControl control(target_ms);
  control.acknowledged(40, 50);
  control.acknowledged(0, 50);
  EXPECT_EQ(control.quality(), 78);
  for (int i = 0; i < 100; ++i) control.acknowledged(10, 50);
  EXPECT_EQ(control.quality(), 78);
}

}  // namespace
}  // namespace cloudscape::stream
