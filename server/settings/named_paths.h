// Camera paths by name: those of config/paths, compiled into the program, and files.
#pragma once
#include <string>
#include <string_view>

#include "settings/camera_path.h"

namespace cloudscape::settings {

CameraPath named_path(std::string_view name);  // throws NotFound, with the nearest name
// A file's path (it holds '/' or ends in .json) or a name. Throws InvalidInput, NotFound, Error.
CameraPath find_path(const std::string& name_or_file);

}  // namespace cloudscape::settings
