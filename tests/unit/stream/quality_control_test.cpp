// What moving frames cost follows the render time and the link: soon, and without pumping.
#include "stream/quality_control.h"

#include <gtest/gtest.h>

#include <random>

namespace cloudscape::stream {
namespace {

constexpr double target_ms = 50;

// A frame costs a part that every frame pays, one that follows the marched pixels and one that follows the kept ones.
struct Cost {
  double fixed_ms, marched_ms;
  double of(const MovingDetail& detail) const {
    const double kept = 1.0 / (detail.resolution_divisor * detail.resolution_divisor);
    return fixed_ms + marched_ms * (kept / detail.reuse * (0.5 + 0.5 / detail.step_factor) + 0.05 * kept);
  }
};

struct Moving {
  DetailControl control{target_ms, 3};
  int changes = 0;
  std::mt19937 random{1};

  void frames(int count, const Cost& cost, double noise = 0) {
    std::uniform_real_distribution<double> factor(1 - noise, 1 + noise);
    for (int i = 0; i < count; ++i) {
      const MovingDetail detail = control.detail();
      control.rendered(detail, cost.of(detail) * factor(random));
      changes += !(control.detail() == detail);
    }
  }
};

TEST(DetailControlTest, every_level_costs_less_than_the_one_before) {
  const Cost cost{0, 1000};
  for (std::size_t i = 1; i < moving_details.size(); ++i)
    EXPECT_LT(cost.of(moving_details[i]), cost.of(moving_details[i - 1])) << i;
}

TEST(DetailControlTest, a_rendered_frame_tells_its_level) {
  for (std::size_t i = 0; i < moving_details.size(); ++i)
    EXPECT_EQ(moving_detail_of(moving_quality(moving_details[i])), static_cast<int>(i));
  EXPECT_GT(moving_quality(moving_details.back()).step_m, render_quality(Quality::interactive).step_m);
}

TEST(DetailControlTest, gives_way_within_some_frames_and_returns_within_twenty) {
  const Cost light{3, 20}, heavy{3, 900};
  Moving moving;
  moving.frames(50, light);
  EXPECT_EQ(moving.control.detail(), moving_details.front());
  moving.frames(4, heavy);
  EXPECT_EQ(moving.control.detail(), (MovingDetail{16, 2})) << "coarser is a matter of a few frames";
  EXPECT_LE(heavy.of({16, 2}), target_ms);
  moving.frames(20, light);
  EXPECT_EQ(moving.control.detail(), moving_details.front());
  moving.changes = 0;
  moving.frames(500, light);
  EXPECT_EQ(moving.changes, 0);
}

TEST(DetailControlTest, one_slow_frame_changes_nothing) {
  Moving moving;
  moving.frames(50, {3, 20});
  moving.changes = 0;
  moving.frames(1, {3, 900});
  moving.frames(10, {3, 20});
  EXPECT_EQ(moving.changes, 0);
}

TEST(DetailControlTest, hopeless_load_stays_coarsest) {
  Moving moving;
  moving.frames(100, {500, 5000});
  EXPECT_EQ(moving.control.detail(), moving_details.back());
  EXPECT_EQ(moving.changes, 1);
}

TEST(DetailControlTest, noise_about_the_target_does_not_pump) {
  for (const Cost cost : {Cost{0, 48}, Cost{0, 160}, Cost{0, 700}, Cost{10, 300}, Cost{20, 1200}, Cost{40, 80}}) {
    Moving moving;
    moving.frames(50, cost, 0.1);
    moving.changes = 0;
    moving.frames(500, cost, 0.1);
    EXPECT_LE(moving.changes, 6) << cost.fixed_ms << " + " << cost.marched_ms;
    EXPECT_LE(cost.of(moving.control.detail()), 1.2 * target_ms);
  }
}

TEST(DetailControlTest, fixed_cost_does_not_leave_the_picture_coarse_after_a_spike) {
  const Cost cost{10, 25};
  Moving moving;
  moving.frames(20, cost);
  moving.frames(3, {10, 5000});
  EXPECT_NE(moving.control.detail(), moving_details.front());
  moving.frames(60, cost);
  EXPECT_EQ(moving.control.detail(), moving_details.front());
}

TEST(DetailControlTest, frame_of_another_detail_tells_nothing) {
  DetailControl control(target_ms, 3);
  for (int i = 0; i < 10; ++i) control.rendered(moving_details.back(), 1000);
  EXPECT_EQ(control.detail(), moving_details[3]);
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
