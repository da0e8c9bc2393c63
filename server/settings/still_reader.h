// A still from a JSON body that is parsed already, as part of a larger one.
#pragma once
#include <nlohmann/json.hpp>

#include "settings/still_request.h"

namespace cloudscape::settings {

// As still_from_json.
StillRequest still_from_parsed(nlohmann::json body, const CloudscapeLibrary& library, const StillLimits& limits);

}  // namespace cloudscape::settings
