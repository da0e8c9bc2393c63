// The cloudscape document from JSON that is parsed already, as part of a larger body.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "core/cloudscape.h"

namespace cloudscape::settings {

// `pointer` is where the document stands: it opens every error's pointer. A top-level "$schema" is passed over, for
// editors. Throws InvalidInput.
Cloudscape read_cloudscape(const nlohmann::json& json, const std::string& pointer);

// The rules that tie several fields together. Throws InvalidInput.
void check(const Cloudscape& cloudscape, const std::string& pointer = "");

}  // namespace cloudscape::settings
