// The scheduler against a simulated network: what a viewer who never rests sees.
#include <ostream>

#include "simulated_viewer.h"

namespace cloudscape::stream {
namespace {

constexpr double produced_ms = 16 + 2;  // rendered and encoded

struct Network {
  double link_mbit_per_s, one_way_ms;
  friend void PrintTo(const Network& network, std::ostream* out) {
    *out << network.link_mbit_per_s << " Mbit/s, " << network.one_way_ms << " ms each way";
  }
};

class LinkTest : public testing::TestWithParam<Network> {
 protected:
  SimulatedViewer viewer;
  void SetUp() override {
    viewer.link_mbit_per_s = GetParam().link_mbit_per_s;
    viewer.one_way_ms = GetParam().one_way_ms;
    viewer.run(10'000);
  }
};

TEST_P(LinkTest, frames_are_no_older_than_the_round_trip_and_two_serialise_times_and_do_not_age) {
  const double round_trip_ms = 2 * viewer.one_way_ms + viewer.decode_ms;
  EXPECT_LE(viewer.age_ms(95, 5000), round_trip_ms + 2 * viewer.serialise_ms() + produced_ms);
  const double early_ms = viewer.age_ms(50, 5000), then_ms = viewer.now_ms();
  viewer.run(60'000);
  EXPECT_LE(viewer.age_ms(50, then_ms + 50'000), early_ms + 1);
}

TEST_P(LinkTest, slowest_stage_or_the_full_window_sets_the_frame_rate) {
  const double way_ms = 2 * viewer.one_way_ms + viewer.decode_ms + viewer.serialise_ms() + produced_ms;
  const double possible = 1000 / std::max({16.0, viewer.serialise_ms(), way_ms / 3});
  EXPECT_GE(viewer.stats().frames_per_second, 0.85 * possible);
}

INSTANTIATE_TEST_SUITE_P(Networks, LinkTest,
                         testing::Values(Network{100, 0.5}, Network{100, 75}, Network{20, 0.5}, Network{20, 40},
                                         Network{10, 10}, Network{4, 10}, Network{4, 75}, Network{1, 10}));

TEST(LinkStepTest, quality_gives_way_within_a_second_and_returns_within_five) {
  SimulatedViewer viewer;
  viewer.link_mbit_per_s = 50;
  viewer.run(3000);
  EXPECT_EQ(viewer.seen.back().jpeg_quality, 85);
  viewer.link_mbit_per_s = 4;
  viewer.run(1000);
  EXPECT_EQ(viewer.seen.back().jpeg_quality, 55);
  viewer.run(1000);
  viewer.link_mbit_per_s = 50;
  viewer.run(5000);
  EXPECT_EQ(viewer.seen.back().jpeg_quality, 85);
}

TEST(LinkStepTest, quality_does_not_pump_on_a_link_between_good_and_bad) {
  for (const double link_mbit_per_s : {6, 8, 10, 12, 15}) {
    SimulatedViewer viewer;
    viewer.link_mbit_per_s = link_mbit_per_s;
    viewer.run(3000);
    const std::size_t settled = viewer.seen.size();
    viewer.run(20'000);
    int falls = 0;
    for (std::size_t i = settled; i < viewer.seen.size(); ++i)
      falls += viewer.seen[i].jpeg_quality < viewer.seen[i - 1].jpeg_quality;
    EXPECT_LE(falls, 2) << link_mbit_per_s << " Mbit/s";
  }
}

TEST(LinkStepTest, heavy_view_is_marched_coarsely_enough_and_a_light_one_finely_again) {
  SimulatedViewer viewer;
  viewer.run(2000);
  viewer.marched_ms = 300;
  viewer.run(1000);
  EXPECT_LE(viewer.stats().render_ms, 50);
  viewer.marched_ms = 12;
  viewer.run(1000);
  EXPECT_NEAR(viewer.stats().render_ms, 16.6, 0.5);
}

}  // namespace
}  // namespace cloudscape::stream
