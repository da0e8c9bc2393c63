#include "net/http_request.h"

#include <algorithm>
#include <charconv>

#include "net/header_list.h"

namespace cloudscape::net {

std::string_view name_of(Method method) {
  constexpr std::string_view names[] = {"GET", "HEAD", "POST", "PUT", "DELETE", "OPTIONS", "other"};
  return names[static_cast<std::size_t>(method)];
}

std::optional<std::uint64_t> content_length(const Request& request) {
  const std::string& text = request.content_length;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool has_body(const Request& request) {
  return !request.transfer_encoding.empty() || (!request.content_length.empty() && content_length(request) != 0U);
}

std::pair<std::string, std::string> query_parameter(std::string_view decoded) {
  const auto equals = std::min(decoded.find('='), decoded.size());
  return {std::string(decoded.substr(0, equals)), std::string(decoded.substr(std::min(equals + 1, decoded.size())))};
}

bool has_token(std::string_view list, std::string_view token) {
  return std::ranges::any_of(split_list(list), [&](auto member) { return equal_without_case(member, token); });
}

}  // namespace cloudscape::net
