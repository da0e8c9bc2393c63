// The test track's tables for people.
#include "bench/track_report.h"

#include <algorithm>
#include <cmath>

#include "bench/track_lookup.h"
#include "core/formatted.h"

namespace cloudscape::bench {
namespace {

constexpr int label_width = 24;

std::string label(const std::string& text) { return formatted("  %-*.*s", label_width, label_width, text.c_str()); }

std::string heading(const ThesisTable& table) {
  std::string first = label("time of a frame, ms"), second = label("");
  for (const TimeKind kind : time_kinds) {
    first += formatted("%10s%17s", name_of(kind).data(), "");
    second += formatted("%9s%9s%9s", "mean", "median", "p95");
  }
  return formatted("Table %s: %s\n", table.number, table.title) + first + formatted("%10s\n", "thesis") + second +
         formatted("%10s\n", "mean");
}

std::string times_line(const TrackTimes& track, const ThesisRow& row) {
  std::string line = label(row.label);
  for (const TimeKind kind : time_kinds) {
    const Summary times = summary_of(times_of(*find(track, row.variant), kind));
    line += formatted("%9.2f%9.2f%9.2f", times.mean_ms, times.median_ms, times.p95_ms);
  }
  return line + formatted("%10.2f\n", row.thesis_ms);
}

std::string ratio_line(const TrackTimes& track, const ThesisRow& row, const ThesisRow& base) {
  std::string line = label(std::string(row.label) + " / " + base.label);
  for (const TimeKind kind : time_kinds) {
    const PairedRatio ratio =
        paired_ratio(times_of(*find(track, row.variant), kind), times_of(*find(track, base.variant), kind));
    line += formatted("%9.3f%9.3f%9s", ratio.of_means, ratio.median, "");
  }
  return line + formatted("%10.3f\n", row.thesis_ms / base.thesis_ms);
}

std::string table_text(const TrackTimes& track, const ThesisTable& table) {
  std::string text = heading(table), ratios;
  for (const ThesisRow& row : table.rows) {
    if (!find(track, row.variant)) continue;
    text += times_line(track, row);
    if (row.variant != TrackVariant::base) ratios += ratio_line(track, row, table.rows.front());
  }
  return text + ratios + "\n";
}

std::string section_table(const TrackTimes& track, TimeKind kind) {
  const std::vector<std::string> sections = section_names(track);
  if (sections.empty()) return "";
  std::string text = formatted("Means by section, %s ms (times the base's)\n", name_of(kind).data()) + label("");
  for (const std::string& section : sections) text += formatted("%20.19s", section.c_str());
  for (const VariantTimes& variant : track.variants) {
    text += "\n" + label(std::string(name_of(variant.variant)));
    for (const std::string& section : sections) {
      const auto times = in_section(track, times_of(variant, kind), section);
      const auto base = in_section(track, times_of(track.variants.front(), kind), section);
      text += formatted("%11.2f (%6.3f)", mean_of(times), paired_ratio(times, base).of_means);
    }
  }
  return text + "\n";
}

}  // namespace

std::string track_tables(const TrackTimes& track) {
  const March& march = track.base_march;
  std::string text = formatted("%zu frames of %dx%d along %s, of %s\n", track.time_s.size(), track.size_px.width,
                               track.size_px.height, track.path.c_str(), track.cloudscape.c_str());
  text += formatted("steps of %g and %g m, to %g m; adaptive from %g m on\n\n", march.step_m.value_or(0),
                    march.large_step_m.value_or(0), march.max_distance_m, march.adaptive_start_m);
  for (const ThesisTable& table : thesis_tables())
    if (measured(track, table)) text += table_text(track, table);
  text += section_table(track, TimeKind::wall) + "\n" + section_table(track, TimeKind::cpu) + "\n";
  return text +
         "Ratios: below mean, that of the means; below median, the median of the frames' own. Thesis: GeForce GTX 680, "
         "1280x720.\n";
}

}  // namespace cloudscape::bench
