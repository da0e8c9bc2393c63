#include "settings/still_documents.h"

#include "settings/described_json.h"
#include "settings/named_documents.h"
#include "settings/still_body.h"
#include "settings/text_file.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_stills;
extern const EmbeddedFiles embedded_truth_views;
}  // namespace cloudscape

namespace cloudscape::settings {
namespace {

constexpr std::size_t max_file_bytes = 256 * 1024;  // as a cloudscape's, which it may hold

using nlohmann::json;

std::string view_of(const json& still) {
  if (!still.at("cloudscape").is_string()) return "";
  if (still.value("/camera/lens/kind"_json_pointer, "perspective") != "perspective") return "";
  std::string view = "cloudscape=" + still["cloudscape"].get<std::string>();
  const auto add = [&](const char* name, const json::json_pointer& place) {
    if (!still.contains(place)) return;
    const json& value = still[place];
    view += std::string("&") + name + '=' +
            (value.is_array() ? value.dump().substr(1, value.dump().size() - 2) : value.dump());
  };
  add("position", "/camera/position_m"_json_pointer);
  add("azimuth_deg", "/camera/azimuth_deg"_json_pointer);
  add("elevation_deg", "/camera/elevation_deg"_json_pointer);
  add("vertical_fov_deg", "/camera/lens/vertical_fov_deg"_json_pointer);
  add("sun_azimuth_deg", "/sun/azimuth_deg"_json_pointer);
  add("sun_elevation_deg", "/sun/elevation_deg"_json_pointer);
  add("exposure_ev", "/image/exposure_ev"_json_pointer);
  return view;
}

std::vector<StillEntry> entries_of(EmbeddedFiles files) {
  std::vector<StillEntry> entries;
  for (const EmbeddedFile& file : files) {
    const json still = parse_json(file.bytes, std::string(file.path));
    entries.push_back({document_name(file), still.value("title", ""), still.value("description", ""), view_of(still)});
  }
  return entries;
}

}  // namespace

std::vector<StillEntry> named_stills() { return entries_of(embedded_stills); }

std::vector<StillEntry> truth_views() { return entries_of(embedded_truth_views); }

StillDocument truth_view(std::string_view name) {
  return {std::string(named_document(embedded_truth_views, name, "view").bytes), ""};
}

StillDocument named_still(std::string_view name) {
  return {std::string(named_document(embedded_stills, name, "still").bytes), ""};
}

StillDocument find_still(const std::string& name_or_file) {
  if (!is_file_path(name_or_file)) return named_still(name_or_file);
  return {read_text_file(name_or_file, max_file_bytes), name_or_file};
}

}  // namespace cloudscape::settings
