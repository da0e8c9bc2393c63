// The test track's figures as JSON.
#include <nlohmann/json.hpp>

#include "bench/track_lookup.h"
#include "bench/track_report.h"
#include "core/version.h"
#include "settings/described_json.h"

namespace cloudscape::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string key_of(TimeKind kind) { return std::string(name_of(kind)); }

Json json_of(const PairedRatio& ratio) { return {{"of_means", ratio.of_means}, {"median_of_frames", ratio.median}}; }

// Summaries of each kind of time, and their ratios to the base's.
Json summaries(const std::function<std::vector<double>(TimeKind)>& times,
               const std::function<std::vector<double>(TimeKind)>& base) {
  Json json;
  for (const TimeKind kind : time_kinds) {
    const Summary summary = summary_of(times(kind));
    json[key_of(kind)] = {{"mean_ms", summary.mean_ms},
                          {"median_ms", summary.median_ms},
                          {"p95_ms", summary.p95_ms},
                          {"over_base", json_of(paired_ratio(times(kind), base(kind)))}};
  }
  return json;
}

Json json_of(const TrackTimes& track, const VariantTimes& variant) {
  const VariantTimes& base = track.variants.front();
  Json json{{"name", name_of(variant.variant)}};
  json.update(summaries([&](TimeKind kind) { return times_of(variant, kind); },
                        [&](TimeKind kind) { return times_of(base, kind); }));
  Json& sections = json["sections"] = Json::object();
  for (const std::string& name : section_names(track))
    sections[name] = summaries([&](TimeKind kind) { return in_section(track, times_of(variant, kind), name); },
                               [&](TimeKind kind) { return in_section(track, times_of(base, kind), name); });
  Json& frames = json["frames"] = Json::object();
  for (const TimeKind kind : time_kinds) frames[key_of(kind) + "_ms"] = times_of(variant, kind);
  return json;
}

Json json_of(const TrackTimes& track, const ThesisTable& table) {
  Json rows = Json::array();
  const VariantTimes& base = track.variants.front();
  for (const ThesisRow& row : table.rows) {
    const VariantTimes* times = find(track, row.variant);
    if (!times) continue;
    Json json{{"label", row.label},
              {"variant", name_of(row.variant)},
              {"thesis_ms", row.thesis_ms},
              {"thesis_over_base", row.thesis_ms / table.rows.front().thesis_ms}};
    for (const TimeKind kind : time_kinds) {
      json[key_of(kind) + "_mean_ms"] = mean_of(times_of(*times, kind));
      json[key_of(kind) + "_over_base"] = json_of(paired_ratio(times_of(*times, kind), times_of(base, kind)));
    }
    rows.push_back(std::move(json));
  }
  return {{"table", table.number}, {"title", table.title}, {"rows", std::move(rows)}};
}

}  // namespace

std::string track_json(const TrackTimes& track, const Machine& machine) {
  Json tables = Json::array(), variants = Json::array();
  for (const ThesisTable& table : thesis_tables())
    if (measured(track, table)) tables.push_back(json_of(track, table));
  for (const VariantTimes& variant : track.variants) variants.push_back(json_of(track, variant));
  const Json document{{"benchmark", "track"},
                      {"program_version", version},
                      {"machine", json_of(machine)},
                      {"cloudscape", track.cloudscape},
                      {"path", track.path},
                      {"size_px", {track.size_px.width, track.size_px.height}},
                      {"base_march", settings::write(track.base_march)},
                      {"tables", std::move(tables)},
                      {"variants", std::move(variants)},
                      {"frames", {{"time_s", track.time_s}, {"section", track.sections}}}};
  return settings::to_text(document, 1) + "\n";
}

}  // namespace cloudscape::bench
