// One HTTP request as plain values: what libwebsockets tells of it, copied out before its header table goes away.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "settings/still_request.h"

namespace cloudscape::net {

enum class Method { get, head, post, put, del, options, other };
std::string_view name_of(Method method);  // "GET"

struct Request {
  Method method = Method::get;
  std::string path;            // decoded, dot segments removed; may hold any byte
  settings::Parameters query;  // decoded
  std::string version;         // "HTTP/1.1"; empty: the request line had none
  std::string client;          // address of the peer
  // Headers; a repeated one is joined by ','; empty where absent.
  std::string host, origin, authorization, if_none_match, range, if_range, connection, expect;
  std::string content_type, content_length, transfer_encoding;
  std::string subprotocols, websocket_version, websocket_key;
  std::string body;
};

// The value of Content-Length: nullopt where it is absent or not a plain decimal number.
std::optional<std::uint64_t> content_length(const Request& request);
bool has_body(const Request& request);  // by its headers

// "name=value" as libwebsockets splits it: already percent-decoded.
std::pair<std::string, std::string> query_parameter(std::string_view decoded);

// Whether a comma-separated header value holds `token`, without regard to case.
bool has_token(std::string_view list, std::string_view token);

}  // namespace cloudscape::net
