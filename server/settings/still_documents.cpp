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

StillHeading heading_of(const EmbeddedFile& file) {
  const nlohmann::json json = parse_json(file.bytes, std::string(file.path));
  StillHeading heading;
  heading.title = json.value("title", "");
  heading.description = json.value("description", "");
  return heading;
}

std::vector<StillEntry> entries_of(EmbeddedFiles files) {
  std::vector<StillEntry> entries;
  for (const EmbeddedFile& file : files) {
    const StillHeading heading = heading_of(file);
    entries.push_back({document_name(file), heading.title, heading.description});
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
