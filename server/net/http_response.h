// One HTTP response as plain values, and its head as text. Every answer of the server goes through here, so that the
// security headers are on all of them.
#pragma once
#include <ctime>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/frame.h"

namespace cloudscape::net {

// Bytes that nobody changes any more, kept alive by whoever owns them.
struct Body {
  std::shared_ptr<const void> owner;
  std::string_view bytes;
  static Body of(std::string text);
  static Body of(const std::shared_ptr<const EncodedFrame>& image);  // without its front
  static Body of_static(std::string_view bytes) { return {nullptr, bytes}; }
};

struct Response {
  int status = 200;
  std::string content_type;
  std::vector<std::pair<std::string, std::string>> headers;
  Body body;
  bool close = false;  // the connection ends after it

  Response& with(std::string name, std::string value);
};

Response text_response(int status, std::string content_type, std::string text);
Response json_response(int status, std::string json);
Response empty_response(int status);  // 204 and 304

std::string_view reason_phrase(int status);
// Status line and headers, the blank line included. An answer to HEAD has the same ones as to GET.
std::string head_text(const Response& response);

// "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7).
std::string http_date(std::time_t time);

// Whether an If-None-Match value names `etag` (weak comparison, RFC 9110 13.1.2).
bool none_match_holds(std::string_view if_none_match, std::string_view etag);
std::string quoted_etag(std::string_view what);  // "\"" + 32 hexadecimal digits of its SHA-256 + "\""

}  // namespace cloudscape::net
