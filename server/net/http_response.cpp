#include "net/http_response.h"

#include <algorithm>
#include <map>

#include "core/content_hash.h"
#include "net/header_list.h"

namespace cloudscape::net {
namespace {

// The page loads its own modules only, opens its own socket, and shows pictures that it made itself (blob:, data:).
constexpr std::string_view security_headers =
    "content-security-policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self' ws: wss:; worker-src 'self' blob:; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'\r\n"
    "x-content-type-options: nosniff\r\n"
    "referrer-policy: no-referrer\r\n"
    "cross-origin-resource-policy: same-origin\r\n";

bool has_no_content(int status) { return status == 204 || status == 304; }

// A header's value comes from our own code only, but a line break in it would be a second header.
std::string one_line(std::string value) {
  std::ranges::replace_if(
      value, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return value;
}

}  // namespace

Body Body::of(std::string text) {
  auto owner = std::make_shared<const std::string>(std::move(text));
  return {owner, *owner};
}

Body Body::of(const std::shared_ptr<const EncodedFrame>& image) {
  const auto* first = reinterpret_cast<const char*>(image->bytes.data());
  return {image, std::string_view(first, image->bytes.size()).substr(image->front)};
}

Response& Response::with(std::string name, std::string value) {
  headers.emplace_back(std::move(name), one_line(std::move(value)));
  return *this;
}

Response text_response(int status, std::string content_type, std::string text) {
  return {status, std::move(content_type), {}, Body::of(std::move(text)), false};
}

Response json_response(int status, std::string json) {
  return text_response(status, "application/json", std::move(json) + "\n");
}

Response empty_response(int status) { return {status, "", {}, {}, false}; }

std::string_view reason_phrase(int status) {
  static const std::map<int, std::string_view> phrases{
      {200, "OK"},
      {201, "Created"},
      {202, "Accepted"},
      {204, "No Content"},
      {206, "Partial Content"},
      {304, "Not Modified"},
      {400, "Bad Request"},
      {401, "Unauthorized"},
      {403, "Forbidden"},
      {404, "Not Found"},
      {405, "Method Not Allowed"},
      {408, "Request Timeout"},
      {409, "Conflict"},
      {411, "Length Required"},
      {413, "Content Too Large"},
      {414, "URI Too Long"},
      {415, "Unsupported Media Type"},
      {416, "Range Not Satisfiable"},
      {421, "Misdirected Request"},
      {422, "Unprocessable Content"},
      {426, "Upgrade Required"},
      {429, "Too Many Requests"},
      {500, "Internal Server Error"},
      {503, "Service Unavailable"},
      {505, "HTTP Version Not Supported"},
  };
  const auto found = phrases.find(status);
  return found == phrases.end() ? "Unknown" : found->second;
}

std::string head_text(const Response& response) {
  std::string text = "HTTP/1.1 " + std::to_string(response.status) + ' ';
  text.append(reason_phrase(response.status)).append("\r\n");
  if (!response.content_type.empty()) text += "content-type: " + response.content_type + "\r\n";
  if (!has_no_content(response.status))
    text += "content-length: " + std::to_string(response.body.bytes.size()) + "\r\n";
  for (const auto& [name, value] : response.headers) text.append(name).append(": ").append(value).append("\r\n");
  if (response.close) text += "connection: close\r\n";
  return text.append(security_headers).append("\r\n");
}

std::string http_date(std::time_t time) {
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[40] = "";
  std::strftime(text, sizeof text, "%a, %d %b %Y %H:%M:%S GMT", &utc);
  return text;
}

bool none_match_holds(std::string_view if_none_match, std::string_view etag) {
  return std::ranges::any_of(split_list(if_none_match), [&](std::string_view member) {
    if (member.starts_with("W/")) member.remove_prefix(2);
    return member == "*" || member == etag;
  });
}

std::string quoted_etag(std::string_view what) { return '"' + sha256_hex(what).substr(0, 32) + '"'; }

}  // namespace cloudscape::net
