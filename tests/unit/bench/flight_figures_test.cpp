// Statistics of flown frames, what holds a frame rate, and the search for the number of streams.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bench/stream_counts.h"
#include "bench/thread_times.h"
#include "core/cpu_time.h"

namespace cloudscape::bench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

FlownFrame frame_at(double at_ms, int detail = 1) { return {at_ms, 50, 20, 15, 1, 2, 10'000, detail}; }

std::vector<FlownFrame> frames_every(double interval_ms, double until_ms) {
  std::vector<FlownFrame> frames;
  for (double at_ms = 0; at_ms < until_ms; at_ms += interval_ms) frames.push_back(frame_at(at_ms));
  return frames;
}

TEST(FlightFigures, CountWholeSecondsAndIntervalsInOrderOfTime) {
  const FlightFigures figures =
      figures_of({frame_at(0, 1), frame_at(1900, 2), frame_at(100, 2), frame_at(400, 3), frame_at(2100, 3)}, 2.5);
  EXPECT_EQ(figures.frames, 5);
  EXPECT_EQ(figures.fps_mean, 2);
  EXPECT_EQ(figures.fps_least, 1);
  EXPECT_EQ(figures.interval.median_ms, 200);
  EXPECT_EQ(figures.interval.max_ms, 1500);
  EXPECT_EQ(figures.render.median_ms, 20);
  EXPECT_EQ(figures.age.p95_ms, 50);
  EXPECT_EQ(figures.bytes, 10'000);
  EXPECT_EQ(figures.detail, 2);
  EXPECT_THAT(fps_of_seconds({frame_at(0), frame_at(999), frame_at(1000), frame_at(5000)}, 3.9), ElementsAre(2, 1, 0));
}

TEST(FlightFigures, AreZerosWithoutFrames) {
  const FlightFigures figures = figures_of({}, 3);
  EXPECT_EQ(figures.fps_mean, 0);
  EXPECT_EQ(figures.interval.max_ms, 0);
  EXPECT_FALSE(holds(figures, 1)) << "who gets nothing holds nothing";
}

TEST(FlightFigures, HoldARateByMedianAndBySlowFrames) {
  EXPECT_TRUE(holds(figures_of(frames_every(33.3, 3000), 3), 30));
  EXPECT_TRUE(holds(figures_of(frames_every(34.9, 3000), 3), 30));
  EXPECT_FALSE(holds(figures_of(frames_every(35.1, 3000), 3), 30));
  std::vector<FlownFrame> stutters = frames_every(10, 1000);
  for (int i = 1; i <= 10; ++i) stutters.push_back(frame_at(1000 + 51 * i));
  EXPECT_TRUE(holds(figures_of(stutters, 2), 20));
  EXPECT_FALSE(holds(figures_of(stutters, 2), 30)) << "the median is one of 100 frames a second";
}

// How many numbers are asked for, and what comes out.
std::pair<int, std::vector<int>> search(int most, int truth) {
  std::vector<int> asked;
  const int found = greatest(most, [&](int streams) {
    asked.push_back(streams);
    return streams <= truth;
  });
  return {found, asked};
}

TEST(StreamSearch, DoublesAndThenHalves) {
  EXPECT_THAT(search(256, 11).second, ElementsAre(1, 2, 4, 8, 16, 12, 10, 11));
  EXPECT_THAT(search(256, 0).second, ElementsAre(1));
  EXPECT_THAT(search(6, 100).second, ElementsAre(1, 2, 4, 6));
  for (const int most : {1, 2, 5, 64, 100})
    for (int truth = 0; truth <= most + 1; ++truth) EXPECT_EQ(search(most, truth).first, std::min(truth, most));
}

// A device that gives 120 frames a second in all.
StreamsFigures shared(int streams) {
  return streams_figures(std::vector<std::vector<FlownFrame>>(streams, frames_every(1000.0 * streams / 120, 4000)), 4);
}

TEST(StreamSearch, MeasuresEachNumberOnce) {
  std::vector<int> measured;
  const StreamsResults results = find_streams(64, [&](int streams) {
    measured.push_back(streams);
    return shared(streams);
  });
  EXPECT_EQ(results.held.at(30), 4);
  EXPECT_EQ(results.held.at(60), 2);
  EXPECT_THAT(measured, ElementsAre(1, 2, 4, 8, 6, 5, 3));
}

TEST(StreamReport, TellsOfTheStreamThatIsWorstOff) {
  StreamsResults results;
  results.measured[2] = streams_figures({frames_every(10, 1000), frames_every(40, 1000)}, 1);
  results.measured[2].stream_bytes = 3 << 20;
  results.measured[2].busy_share = 0.75;
  results.held = {{30, 1}, {60, 0}};
  const std::string text = streams_table(results, {"sky", "track", {64, 36}, 8});
  EXPECT_THAT(text, testing::ContainsRegex("\n +2 +25.0 +40.0 +40.0 +1 +75% .* 3.0 "));
  EXPECT_THAT(text, HasSubstr("30 frames a second: 1 streams\n60 frames a second: 0 streams"));
  const auto json = nlohmann::json::parse(streams_json(results, {"sky", "track", {64, 36}, 8}, {}));
  EXPECT_EQ(json["streams_that_hold_fps"]["30"], 1);
  EXPECT_EQ(json["measured"][0]["each"].size(), 2u);
  EXPECT_EQ(json["measured"][0]["busy_share"], 0.75);
}

TEST(StreamReport, SaysOfOneNumberWhetherItHolds) {
  StreamsResults results;
  results.measured[3] = shared(3);
  results.held = {{30, 3}, {60, 0}};
  const std::string text = streams_table(results, {"sky", "track", {64, 36}, 0});
  EXPECT_THAT(text, HasSubstr("30 frames a second: held\n60 frames a second: not held"));
}

TEST(ThreadTimes, CountThreadsOfOneNameTogether) {
  EXPECT_EQ(without_number("llvmpipe-12"), "llvmpipe");
  EXPECT_EQ(without_number("encode"), "encode");
  EXPECT_EQ(without_number("42"), "42");
  EXPECT_THAT(since({{"a", 1}, {"b", 5}}, {{"a", 4}, {"b", 5}, {"c", 2}}),
              ElementsAre(std::pair("a", 3.0), std::pair("c", 2.0)));
}

TEST(ThreadTimes, GrowByWhatIsComputed) {
  const double process_ms = process_cpu_ms();
  const ThreadTimes before = thread_cpu_ms();
  volatile double work = 1;
  while (process_cpu_ms() - process_ms < 40) work = work * 1.0000001;
  double spent_ms = 0;
  for (const auto& [name, ms] : since(before, thread_cpu_ms())) spent_ms += ms;
  EXPECT_GT(spent_ms, 20);
}

}  // namespace
}  // namespace cloudscape::bench
