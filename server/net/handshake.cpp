#include "net/handshake.h"

#include <algorithm>

#include "net/header_list.h"
#include "net/metric_names.h"
#include "net/problem.h"
#include "net/request_checks.h"
#include "wire/messages.h"

namespace cloudscape::net {
namespace {

// lws_process_ws_upgrade reads the list and the Connection header into buffers of 128 bytes, and hangs up without an
// answer on longer ones.
constexpr std::size_t max_list_bytes = 126;

bool is_base64(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' || c == '/';
}

std::optional<Response> refuse_form(const Request& request) {
  if (request.method != Method::get || request.version != "HTTP/1.1")
    return problem(400, "A WebSocket opens with GET and HTTP/1.1.");
  if (request.connection.size() > max_list_bytes || !has_token(request.connection, "upgrade"))
    return problem(400, "A WebSocket opens with \"Connection: Upgrade\".");
  if (request.websocket_version != "13")
    return problem(426, "Only version 13 of the WebSocket protocol is spoken.").with("sec-websocket-version", "13");
  if (!valid_websocket_key(request.websocket_key)) return problem(400, "Sec-WebSocket-Key must be 16 bytes in base64.");
  return std::nullopt;
}

std::optional<Response> refuse_subprotocols(const Request& request) {
  const auto offered = split_list(request.subprotocols);
  const bool fits = request.subprotocols.size() <= max_list_bytes;
  if (!fits || offered.empty() || offered.front() != wire::subprotocol)
    return problem(400, "Offer the subprotocol cloudscape.v1 first, in a list of at most 126 characters.");
  return std::nullopt;
}

}  // namespace

bool valid_websocket_key(std::string_view key) {
  return key.size() == 24 && key.ends_with("==") && std::ranges::all_of(key.substr(0, 22), is_base64);
}

std::optional<Response> refuse_upgrade(const Request& request, const Site& site) {
  if (auto refused = refuse_malformed(request, 0)) return refused;
  if (auto refused = refuse_stranger(request, site, true)) return refused;
  if (request.path != stream_path) return problem(404, "A WebSocket opens at /api/v1/stream only.");
  if (auto refused = refuse_form(request)) return refused;
  if (auto refused = refuse_subprotocols(request)) return refused;
  if (!site.authorization.accepts_origin(request)) {
    site.parts.metrics.count(metric::refused("origin"));
    return problem(403, "Pages of other sites may not open a stream; see allowed_origins.");
  }
  if (auto refused = refuse_stranger(request, site, false)) return refused;
  if (auto refused = refuse_unready(site)) return refused;
  if (site.sessions.size() >= static_cast<std::size_t>(site.parts.settings.max_streams)) {
    site.parts.metrics.count(metric::refused("streams"));
    return busy(503, "All " + std::to_string(site.parts.settings.max_streams) + " streams are taken (max_streams).", 5);
  }
  return std::nullopt;
}

}  // namespace cloudscape::net
