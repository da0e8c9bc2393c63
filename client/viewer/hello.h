// What the viewer asks for first.
#pragma once
#include "viewer/options.h"
#include "wire/messages.h"

namespace cloudscape::viewer {

// A cloudscape with '/' or ending in .json is a file, whose document goes along. Throws Error if it cannot be read or
// is not valid.
wire::Settings first_settings(const Options& options);

std::string read_file(const std::string& path);  // throws Error

}  // namespace cloudscape::viewer
