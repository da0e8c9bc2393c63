// Documents that are compiled into the program, by name: that of their file in config, without its ending.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/embedded.h"

namespace cloudscape::settings {

// Whether what a person gave is a file's path (it holds '/' or ends in .json) and not a name.
bool is_file_path(std::string_view name_or_file);
std::string document_name(const EmbeddedFile& file);
std::vector<std::string> document_names(EmbeddedFiles files);
// `kind` is what an error calls them: "camera path". Throws NotFound, with the nearest name.
const EmbeddedFile& named_document(EmbeddedFiles files, std::string_view name, const std::string& kind);

}  // namespace cloudscape::settings
