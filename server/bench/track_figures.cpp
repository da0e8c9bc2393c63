// The test track's plots.
#include <algorithm>
#include <string_view>

#include "bench/track_lookup.h"
#include "bench/track_report.h"

namespace cloudscape::bench {
namespace {

constexpr const char* time_label = "time along the track, s";

std::vector<PlotMark> section_marks(const TrackTimes& track) {
  std::vector<PlotMark> marks;
  for (std::size_t i = 0; i < track.time_s.size(); ++i) {
    const std::string before = i == 0 ? "" : track.sections[i - 1];
    if (track.sections[i].empty() || track.sections[i] == before) continue;
    marks.push_back({i == 0 ? track.time_s[0] : (track.time_s[i - 1] + track.time_s[i]) / 2, track.sections[i]});
  }
  return marks;
}

LinePlot time_plot(const TrackTimes& track, const ThesisTable& table, const std::string& title, TimeKind kind) {
  LinePlot plot{title, time_label, std::string(name_of(kind)) + " time of a frame, ms",
                false, {},         section_marks(track)};
  for (const ThesisRow& row : table.rows)
    if (const VariantTimes* times = find(track, row.variant))
      plot.lines.push_back({std::string(table.title) + " " + row.label, track.time_s, times_of(*times, kind)});
  return plot;
}

LinePlot ratio_plot(const TrackTimes& track, const ThesisRow& row, const std::string& title, TimeKind kind) {
  const auto times = times_of(*find(track, row.variant), kind);
  const auto base = times_of(track.variants.front(), kind);
  return {title,
          time_label,
          std::string(name_of(kind)) + " time, times the base's",
          false,
          {{std::string(name_of(row.variant)) + " / base", track.time_s, ratios_of(times, base)}},
          section_marks(track)};
}

bool has_times(const TrackTimes& track, TimeKind kind) {
  const auto times = times_of(track.variants.front(), kind);
  return std::any_of(times.begin(), times.end(), [](double time_ms) { return time_ms > 0; });
}

std::string title_of(const std::string& number, const ThesisTable& table) {
  return "Figure " + number + ": " + table.title;
}

}  // namespace

std::vector<Figure> track_figures(const TrackTimes& track) {
  constexpr const char* figure_numbers[] = {"3.1", "3.2", "3.4", "3.5"};  // of tables 3.1 to 3.4
  std::vector<Figure> figures;
  for (const TimeKind kind : time_kinds) {
    if (!has_times(track, kind)) continue;
    const std::string ending = "-" + std::string(name_of(kind)) + ".svg";
    for (std::size_t i = 0; i < thesis_tables().size(); ++i) {
      const ThesisTable& table = thesis_tables()[i];
      const std::string number = figure_numbers[i];
      if (!measured(track, table)) continue;
      figures.push_back({"figure-" + number + ending, time_plot(track, table, title_of(number, table), kind)});
      if (number == "3.2")
        figures.push_back(
            {"figure-3.3" + ending, ratio_plot(track, table.rows.back(), title_of("3.3", table) + ", on / off", kind)});
    }
  }
  return figures;
}

}  // namespace cloudscape::bench
