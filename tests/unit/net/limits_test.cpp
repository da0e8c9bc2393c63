// Rates and the cache, with a clock of their own.
#include "net/limits.h"

#include <gtest/gtest.h>

#include "net/still_cache.h"
#include "net/stream_statistics.h"

namespace cloudscape::net {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(TokenBucket, gives_a_burst_and_then_the_rate) {
  TokenBucket bucket(10, 5);
  const Instant start = Instant{} + seconds(100);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(bucket.take(start));
  EXPECT_FALSE(bucket.take(start));
  EXPECT_FALSE(bucket.take(start + milliseconds(50)));
  EXPECT_TRUE(bucket.take(start + milliseconds(100)));
  int taken = 0;
  for (int ms = 100; ms < 10100; ms += 10) taken += bucket.take(start + milliseconds(ms));
  EXPECT_NEAR(taken, 100, 1);
}

TEST(RateLimit, clients_do_not_share_and_idle_ones_are_forgotten) {
  RateLimit limit(1, 1);
  const Instant start = Instant{} + seconds(100);
  EXPECT_TRUE(limit.take("a", start));
  EXPECT_FALSE(limit.take("a", start));
  EXPECT_TRUE(limit.take("b", start));
  for (int i = 0; i < 5000; ++i) limit.take("client " + std::to_string(i), start + seconds(10 + i));
  EXPECT_LE(limit.clients(), 1024U);
}

std::shared_ptr<const EncodedFrame> image(std::size_t bytes) {
  return std::make_shared<const EncodedFrame>(EncodedFrame{std::vector<std::uint8_t>(bytes), 0, ImageFormat::png, 0});
}

TEST(StillCache, forgets_the_least_recently_used_above_its_size) {
  StillCache cache(100);
  cache.put("a", image(40));
  cache.put("b", image(40));
  EXPECT_NE(cache.find("a"), nullptr);
  cache.put("c", image(40));
  EXPECT_EQ(cache.find("b"), nullptr);
  EXPECT_NE(cache.find("a"), nullptr);
  EXPECT_NE(cache.find("c"), nullptr);
  EXPECT_EQ(cache.bytes(), 80U);
  cache.put("d", image(101));
  EXPECT_EQ(cache.find("d"), nullptr);
  EXPECT_EQ(cache.bytes(), 80U);
  cache.put("a", image(10));  // known already: kept as it was
  EXPECT_EQ(cache.bytes(), 80U);
}

TEST(StreamStatistics, the_window_is_the_most_that_was_under_way) {
  StreamStatistics statistics;
  Instant now = Instant{} + seconds(1);
  EXPECT_FALSE(statistics.take(now));
  for (std::uint32_t id = 1; id <= 3; ++id) statistics.sent(id, 100, 10, 2, now);
  statistics.acknowledged(2, now + milliseconds(30));  // 1 was skipped
  statistics.acknowledged(1, now + milliseconds(90));
  const auto stats = statistics.take(now + seconds(1));
  ASSERT_TRUE(stats);
  EXPECT_EQ(stats->window, 3);
  EXPECT_NEAR(stats->round_trip_ms, 30, 1e-9);
  EXPECT_NEAR(stats->bits_per_second, 2400, 1e-9);
  EXPECT_NEAR(stats->render_ms, 10, 1e-9);
}

}  // namespace
}  // namespace cloudscape::net
