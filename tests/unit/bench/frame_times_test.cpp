// The figures that the benchmarks print: order statistics, table and JSON.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bench/frame_times.h"

namespace cloudscape::bench {
namespace {

TEST(Spread, TakesTheNearestRank) {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  const Spread spread = spread_of(values);
  EXPECT_EQ(spread.median_ms, 50);
  EXPECT_EQ(spread.p95_ms, 95);
  EXPECT_EQ(spread.max_ms, 100);
}

TEST(Spread, OfOneOrNoValue) {
  EXPECT_EQ(spread_of({7}).p95_ms, 7);
  EXPECT_EQ(spread_of({}).max_ms, 0);
}

FrameTimes row() { return {"overcast", "interactive", {640, 360}, 2, 3, {1, 2, 3}, {4, 5, 6}, {0.5, 0.6, 0.7}, 2048}; }

TEST(FrameTimes, TableHasARowForEach) {
  const std::string table = table_of({row(), row()});
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
  EXPECT_THAT(table, testing::HasSubstr("640x360"));
  EXPECT_THAT(table, testing::HasSubstr("2.0\n")) << "KiB";
  FrameTimes timed = row();
  timed.passes = {{"march", 30, 55}, {"tone_map", 2.25, 4}};
  EXPECT_THAT(table_of({timed}), testing::HasSubstr("2.0\n    march 30.0 tone_map 2.2 ms\n"));
}

TEST(FrameTimes, JsonHoldsEveryFigure) {
  FrameTimes timed = row();
  timed.passes = {{"march", 30, 55}};
  const auto json = nlohmann::json::parse(json_of({timed}, "llvmpipe", "fragment"));
  EXPECT_EQ(json["renderer"], "llvmpipe");
  const auto& times = json["frame_times"][0];
  EXPECT_EQ(times["size_px"], (nlohmann::json{640, 360}));
  EXPECT_EQ(times["render"]["p95_ms"], 2);
  EXPECT_EQ(times["device"]["median_ms"], 4);
  EXPECT_EQ(times["jpeg_bytes"], 2048);
  EXPECT_EQ(times["passes"][0]["name"], "march");
  EXPECT_EQ(times["passes"][0]["ms"], 30);
  EXPECT_EQ(times["passes"][0]["cpu_ms"], 55);
}

}  // namespace
}  // namespace cloudscape::bench
