#include "settings/named_documents.h"

#include <filesystem>

#include "core/error.h"
#include "settings/json_text.h"

namespace cloudscape::settings {

bool is_file_path(std::string_view name_or_file) {
  return name_or_file.find('/') != std::string_view::npos || name_or_file.ends_with(".json");
}

std::string document_name(const EmbeddedFile& file) { return std::filesystem::path(file.path).stem().string(); }

std::vector<std::string> document_names(EmbeddedFiles files) {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : files) names.push_back(document_name(file));
  return names;
}

const EmbeddedFile& named_document(EmbeddedFiles files, std::string_view name, const std::string& kind) {
  for (const EmbeddedFile& file : files)
    if (document_name(file) == name) return file;
  const std::vector<std::string> names = document_names(files);
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw NotFound("there is no " + kind + " " + shown(std::string(name)) + ": " + suggestion(name, known));
}

}  // namespace cloudscape::settings
