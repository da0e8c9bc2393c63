// A file as a body: its pages are read as they are sent, so that it is never in memory as a whole.
#pragma once
#include <filesystem>

#include "net/http_response.h"

namespace cloudscape::net {

// The file must not change any more; it may be removed. Throws Error.
Body mapped_body(const std::filesystem::path& file);

}  // namespace cloudscape::net
