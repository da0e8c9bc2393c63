// Percentiles, latency, rates, and the report that they go to.
#include "viewer/meters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "viewer/report.h"
#include "viewer/title.h"

namespace cloudscape::viewer {
namespace {

using std::chrono::milliseconds;

const Time start{std::chrono::hours(1)};

TEST(Percentile, IsTheNearestRank) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1.0);
  std::shuffle(values.begin(), values.end(), std::mt19937(1));
  EXPECT_EQ(percentile(values, 50), 50);
  EXPECT_EQ(percentile(values, 95), 95);
  EXPECT_EQ(percentile(values, 99), 99);
  EXPECT_EQ(percentile(values, 100), 100);
  EXPECT_EQ(percentile(values, 0), 1);
}

TEST(Percentile, OfFewValuesIsOneOfThem) {
  EXPECT_EQ(percentile({}, 50), 0);
  EXPECT_EQ(percentile({7}, 1), 7);
  EXPECT_EQ(percentile({1, 2, 3}, 50), 2);
  EXPECT_EQ(percentile({1, 2, 3}, 99), 3);
}

TEST(Latency, CountsTheFirstFrameOfEachPose) {
  LatencyMeter meter;
  meter.sent(1, start);
  meter.sent(2, start + milliseconds(10));
  EXPECT_EQ(meter.displayed(2, start + milliseconds(70)), 60);
  EXPECT_EQ(meter.displayed(2, start + milliseconds(90)), std::nullopt) << "a refinement";
  EXPECT_EQ(meter.displayed(1, start + milliseconds(95)), std::nullopt) << "a pose that the server had skipped";
  EXPECT_EQ(meter.displayed(0, start + milliseconds(95)), std::nullopt) << "the frame before any pose";
  EXPECT_EQ(meter.all_ms(), std::vector<double>{60});
}

TEST(Rate, CountsTheLastSecondOnly) {
  RateMeter meter;
  for (int i = 0; i < 40; ++i) meter.add(start + milliseconds(50 * i), 3);
  EXPECT_EQ(meter.per_second(start + milliseconds(50 * 39)), 20 * 3);
  EXPECT_EQ(meter.per_second(start + std::chrono::seconds(10)), 0);
}

TEST(Report, SumsUpTheFlight) {
  FlightRecord record;
  record.poses_sent = 12;
  record.frames = 10;
  record.duration_s = 0.5;
  record.latency_ms = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
  StreamStatus status;
  status.welcome.emplace();
  status.welcome->renderer = "llvmpipe \"LLVM\"";
  status.stats.frames_dropped = 3;
  status.stats.window = 2;
  status.frames_skipped = 1;
  status.bytes_received = 1000;
  status.connections = 2;
  const auto report = nlohmann::json::parse(report_json(record, status, "host:1"));
  EXPECT_EQ(report["frames"], 10);
  EXPECT_EQ(report["fps"], 20);
  EXPECT_EQ(report["latency_ms"]["p50"], 50);
  EXPECT_EQ(report["latency_ms"]["p99"], 100);
  EXPECT_EQ(report["drops"]["total"], 4);
  EXPECT_EQ(report["bits_per_second"], 16000);
  EXPECT_EQ(report["renderer"], "llvmpipe \"LLVM\"");
  EXPECT_EQ(report["window"], 2);
  EXPECT_EQ(report["reconnections"], 1);
}

TEST(Report, OfNothingHasNoInfinities) {
  const auto report = nlohmann::json::parse(report_json({}, {}, "host:1"));
  EXPECT_EQ(report["fps"], 0);
  EXPECT_EQ(report["reconnections"], 0);
}

TEST(Title, SaysWhatIsWrongBeforeAnythingElse) {
  StreamStatus status;
  EXPECT_EQ(title(status, {}, true), "cloudscape · connecting");
  status.notice = "No connection to host:1.";
  EXPECT_EQ(title(status, {}, true), "cloudscape · No connection to host:1.");
  status.connected = true;
  status.notice.clear();
  status.welcome.emplace();
  status.welcome->cloudscape = "overcast";
  status.welcome->renderer = "llvmpipe";
  status.welcome->software = true;
  EXPECT_EQ(title(status, {24.4, 61.2, 8.34e6, 200}, true),
            "overcast · 24 fps · 61 ms · 8.3 Mbit/s · 200 m/s · llvmpipe (software)");
  EXPECT_EQ(title(status, {24.4, 61.2, 8.34e6, 200}, false), "overcast");
}

}  // namespace
}  // namespace cloudscape::viewer
