#include "bench/truth_views.h"

#include "bench/chosen_names.h"
#include "settings/still_request.h"

namespace cloudscape::bench {

std::vector<TruthView> truth_views_of(const std::string& text, const settings::CloudscapeLibrary& library) {
  const std::vector<settings::StillEntry> entries = settings::truth_views();
  std::vector<std::string_view> known;
  for (const settings::StillEntry& entry : entries) known.push_back(entry.name);
  const auto names = chosen_names("--views", text, known);
  std::vector<TruthView> views;
  for (const settings::StillEntry& entry : entries) {
    if (std::find(names.begin(), names.end(), entry.name) == names.end()) continue;
    const settings::StillRequest still =
        settings::still_from_document(settings::truth_view(entry.name), {}, library, settings::StillLimits{});
    views.push_back({entry.name, entry.title, entry.description, still.frame});
    views.back().request.stream = 1;
  }
  return views;
}

}  // namespace cloudscape::bench
