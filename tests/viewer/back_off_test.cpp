// Waiting before the next attempt.
#include "viewer/back_off.h"

#include <gtest/gtest.h>

#include <set>

namespace cloudscape::viewer {
namespace {

TEST(BackOff, LongestWaitsDoubleUpToTheirLimit) {
  BackOff back_off([] { return 1.0; });
  for (const double longest_s : {0.5, 1.0, 2.0, 4.0, 8.0, 10.0, 10.0}) EXPECT_NEAR(back_off.next_s(), longest_s, 1e-12);
}

TEST(BackOff, ItsShortestWaitNeverGrows) {
  BackOff back_off([] { return 0.0; });
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(back_off.next_s(), BackOff::least_s, 1e-12);
}

TEST(BackOff, AConnectionForgetsTheAttempts) {
  BackOff back_off([] { return 1.0; });
  for (int i = 0; i < 5; ++i) back_off.next_s();
  back_off.reset();
  EXPECT_NEAR(back_off.next_s(), BackOff::first_s, 1e-12);
}

TEST(BackOff, ClientsSpreadOut) {
  std::set<double> waits_s;
  for (int client = 0; client < 50; ++client) waits_s.insert(BackOff(random_uniform()).next_s());
  EXPECT_GT(waits_s.size(), 45u);
  EXPECT_GT(*waits_s.rbegin() - *waits_s.begin(), 0.2);
}

}  // namespace
}  // namespace cloudscape::viewer
