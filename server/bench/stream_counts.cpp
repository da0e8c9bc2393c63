#include "bench/stream_counts.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/formatted.h"
#include "core/version.h"
#include "settings/json_text.h"

namespace cloudscape::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const StreamsFigures& figures) {
  Json each = Json::array();
  for (const FlightFigures& flight : figures.each)
    each.push_back({{"fps", flight.fps_mean},
                    {"interval_median_ms", flight.interval.median_ms},
                    {"interval_p95_ms", flight.interval.p95_ms},
                    {"detail", flight.detail}});
  return {{"streams", figures.streams},
          {"busy_share", figures.busy_share},
          {"cpu_ms_per_frame", figures.cpu_ms},
          {"bytes_per_stream", figures.stream_bytes},
          {"sky_tables_per_s", figures.sky_bakes},
          {"each", std::move(each)}};
}

std::string held_text(const StreamsResults& results, const StreamsSubject& subject) {
  std::string text;
  for (const auto& [fps, streams] : results.held) {
    if (subject.most > 0)
      text += formatted("%d frames a second: %d streams%s\n", fps, streams, streams == subject.most ? " or more" : "");
    else
      text += formatted("%d frames a second: %s\n", fps, streams > 0 ? "held" : "not held");
  }
  return text;
}

}  // namespace

StreamsFigures streams_figures(const std::vector<std::vector<FlownFrame>>& frames, double seconds) {
  StreamsFigures figures;
  figures.streams = static_cast<int>(frames.size());
  for (const std::vector<FlownFrame>& stream : frames) figures.each.push_back(figures_of(stream, seconds));
  return figures;
}

bool holds(const StreamsFigures& streams, double fps) {
  return !streams.each.empty() &&
         std::ranges::all_of(streams.each, [&](const FlightFigures& flight) { return holds(flight, fps); });
}

FlightFigures worst_of(const StreamsFigures& streams) {
  const auto worst = std::ranges::max_element(streams.each, {}, [](const FlightFigures& flight) {
    return flight.frames > 1 ? flight.interval.median_ms : std::numeric_limits<double>::max();
  });
  return worst == streams.each.end() ? FlightFigures{} : *worst;
}

int greatest(int most, const std::function<bool(int)>& holds) {
  int held = 0, tried = 1;
  while (tried <= most && holds(tried))
    held = std::exchange(tried, tried == most ? most + 1 : std::min(2 * tried, most));
  int failed = tried;
  while (failed - held > 1) {
    const int middle = (held + failed) / 2;
    (holds(middle) ? held : failed) = middle;
  }
  return held;
}

StreamsResults find_streams(int most, const std::function<StreamsFigures(int)>& measure) {
  StreamsResults results;
  const auto measured = [&](int streams) -> const StreamsFigures& {
    const auto found = results.measured.find(streams);
    return found != results.measured.end() ? found->second
                                           : results.measured.emplace(streams, measure(streams)).first->second;
  };
  for (const double fps : asked_fps)
    results.held[static_cast<int>(fps)] = greatest(most, [&](int streams) { return holds(measured(streams), fps); });
  return results;
}

std::string streams_table(const StreamsResults& results, const StreamsSubject& subject) {
  std::string text =
      formatted("%dx%d, %s along %s; of the stream that is worst off: frames a second, intervals\n",
                subject.size_px.width, subject.size_px.height, subject.cloudscape.c_str(), subject.path.c_str());
  text += formatted("%8s %6s %10s %8s %6s %7s %13s %12s %6s\n", "streams", "fps", "median ms", "p95 ms", "detail",
                    "busy", "CPU ms/frame", "MiB/stream", "sky/s");
  for (const auto& [streams, figures] : results.measured) {
    const FlightFigures worst = worst_of(figures);
    text += formatted("%8d %6.1f %10.1f %8.1f %6d %6.0f%% %13.1f %12.1f %6d\n", streams, worst.fps_mean,
                      worst.interval.median_ms, worst.interval.p95_ms, worst.detail, 100 * figures.busy_share,
                      figures.cpu_ms, figures.stream_bytes / (1024 * 1024), figures.sky_bakes);
  }
  return text + held_text(results, subject);
}

std::string streams_json(const StreamsResults& results, const StreamsSubject& subject, const Machine& machine) {
  Json measured = Json::array(), held = Json::object();
  for (const auto& [streams, figures] : results.measured) measured.push_back(json_of(figures));
  for (const auto& [fps, streams] : results.held) held[std::to_string(fps)] = streams;
  const Json document{{"benchmark", "streams"},
                      {"program_version", version},
                      {"machine", json_of(machine)},
                      {"cloudscape", subject.cloudscape},
                      {"path", subject.path},
                      {"size_px", {subject.size_px.width, subject.size_px.height}},
                      {"streams_that_hold_fps", std::move(held)},
                      {"measured", std::move(measured)}};
  return settings::to_text(document, 1) + "\n";
}

}  // namespace cloudscape::bench
