// What is refused before any route is looked at: requests that are malformed, too large, or not meant for this server.
#pragma once
#include <optional>

#include "net/http_request.h"
#include "net/http_response.h"
#include "net/site.h"

namespace cloudscape::net {

// Version, Host, path, and how the body is framed. What fails here may leave bytes on the connection that are no
// request: the answer closes it.
std::optional<Response> refuse_malformed(const Request& request, std::uint64_t max_body_bytes);
// Host, Origin and token. `open`: the route needs no token.
std::optional<Response> refuse_stranger(const Request& request, const Site& site, bool open);

}  // namespace cloudscape::net
