// The files that a document names, beside what it says itself.
#pragma once
#include <string>

#include "core/cloudscape.h"
#include "settings/server_settings.h"

namespace cloudscape::settings {

// Other text after any of them was changed; "" where the document names none.
std::string stamps_of_named_files(const Cloudscape& cloudscape, const ServerSettings& settings);

}  // namespace cloudscape::settings
