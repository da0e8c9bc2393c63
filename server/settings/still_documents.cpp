#include "settings/still_documents.h"

#include "settings/described_json.h"
#include "settings/named_documents.h"
#include "settings/still_body.h"
#include "settings/text_file.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_stills;
}

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

}  // namespace

std::vector<StillEntry> named_stills() {
  std::vector<StillEntry> entries;
  for (const EmbeddedFile& file : embedded_stills) {
    const StillHeading heading = heading_of(file);
    entries.push_back({document_name(file), heading.title, heading.description});
  }
  return entries;
}

StillDocument named_still(std::string_view name) {
  return {std::string(named_document(embedded_stills, name, "still").bytes), ""};
}

StillDocument find_still(const std::string& name_or_file) {
  if (!is_file_path(name_or_file)) return named_still(name_or_file);
  return {read_text_file(name_or_file, max_file_bytes), name_or_file};
}

}  // namespace cloudscape::settings
