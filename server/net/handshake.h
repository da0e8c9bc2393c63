// The WebSocket handshake: who may open a stream. libwebsockets 4.1.6 lets nearly everything through (any version, any
// key, any path), so all of RFC 6455 4.2.1 is checked here.
#pragma once
#include <optional>

#include "net/http_request.h"
#include "net/http_response.h"
#include "net/site.h"

namespace cloudscape::net {

constexpr std::string_view stream_path = "/api/v1/stream";
// libwebsockets binds a connection to the first protocol it knows of the client's list; the one for HTTP must not be
// reachable so.
constexpr std::string_view http_protocol_name = "cloudscape-http";

// The answer to an upgrade that is refused; nullopt where the stream may be opened.
std::optional<Response> refuse_upgrade(const Request& request, const Site& site);
bool valid_websocket_key(std::string_view key);  // base64 of 16 bytes

}  // namespace cloudscape::net
