// Metrics as Prometheus reads them.
#include "core/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <thread>

namespace cloudscape {
namespace {

using testing::HasSubstr;

TEST(Metrics, CountsAndSets) {
  Metrics metrics;
  metrics.count("frames_total");
  metrics.count("frames_total", 2);
  metrics.set("streams", 5);
  metrics.set("streams", 4);
  EXPECT_EQ(metrics.value("frames_total"), 3);
  EXPECT_EQ(metrics.value("streams"), 4);
  EXPECT_EQ(metrics.value("nothing"), 0);
  EXPECT_EQ(metrics.prometheus_text(),
            "# TYPE frames_total counter\nframes_total 3\n# TYPE streams gauge\nstreams 4\n");
}

TEST(Metrics, LabelsShareOneFamily) {
  Metrics metrics;
  metrics.count(R"(dropped_total{reason="replaced"})");
  metrics.count(R"(dropped_total{reason="closed"})", 2);
  metrics.count("dropped_total");
  metrics.count("dropped_total_bytes", 7);
  EXPECT_EQ(metrics.prometheus_text(),
            "# TYPE dropped_total counter\ndropped_total 1\ndropped_total{reason=\"closed\"} 2\n"
            "dropped_total{reason=\"replaced\"} 1\n# TYPE dropped_total_bytes counter\ndropped_total_bytes 7\n");
}

TEST(Metrics, HistogramsAreCumulative) {
  Metrics metrics;
  for (const double value_ms : {0.5, 1.0, 30.0, 20000.0}) metrics.observe_ms("render_ms", value_ms);
  const std::string text = metrics.prometheus_text();
  for (const char* line :
       {"# TYPE render_ms histogram\n", "render_ms_bucket{le=\"1\"} 2\n", "render_ms_bucket{le=\"20\"} 2\n",
        "render_ms_bucket{le=\"50\"} 3\n", "render_ms_bucket{le=\"10000\"} 3\n", "render_ms_bucket{le=\"+Inf\"} 4\n",
        "render_ms_sum 20031.5\n", "render_ms_count 4\n"})
    EXPECT_THAT(text, HasSubstr(line));
}

TEST(Metrics, HistogramsTakeLabels) {
  Metrics metrics;
  metrics.observe_ms(R"(request_ms{route="stills"})", 3);
  metrics.observe_ms(R"(request_ms{route="page"})", 3);
  const std::string text = metrics.prometheus_text();
  EXPECT_THAT(text, HasSubstr("request_ms_bucket{route=\"stills\",le=\"5\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("request_ms_sum{route=\"page\"} 3\n"));
  EXPECT_THAT(text, HasSubstr("request_ms_count{route=\"page\"} 1\n"));
  EXPECT_EQ(text.find("# TYPE"), text.rfind("# TYPE")) << "one family";
}

TEST(Metrics, TakeManyThreads) {
  Metrics metrics;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int n = 0; n < 1000; ++n) metrics.count("n_total"), metrics.observe_ms("t_ms", n), metrics.set("g", n);
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(metrics.value("n_total"), 4000);
  EXPECT_THAT(metrics.prometheus_text(), HasSubstr("t_ms_count 4000\n"));
}

}  // namespace
}  // namespace cloudscape
