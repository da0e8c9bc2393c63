// The OpenAPI 3.1 document of the HTTP API, built from the same descriptions that read the requests.
#pragma once
#include <string>

#include "settings/server_settings.h"

namespace cloudscape::net {

std::string openapi_document(const settings::ServerSettings& settings);

}  // namespace cloudscape::net
