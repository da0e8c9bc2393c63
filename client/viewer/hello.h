// What the viewer asks for first.
#pragma once
#include "viewer/options.h"
#include "wire/messages.h"

namespace cloudscape::viewer {

// A cloudscape with '/' or ending in .json is a file, whose text goes along. Throws Error if it cannot be read.
wire::Settings first_settings(const Options& options);

std::string read_file(const std::string& path);  // throws Error

}  // namespace cloudscape::viewer
