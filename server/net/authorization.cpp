#include "net/authorization.h"

#include <openssl/crypto.h>
#include <openssl/rand.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.h"
#include "core/log.h"
#include "net/header_list.h"

namespace cloudscape::net {
namespace {

// libwebsockets reads at most 127 bytes of Sec-WebSocket-Protocol, which holds "cloudscape.v1, bearer." and the token.
constexpr std::size_t min_token_characters = 16, max_token_characters = 96;

bool can_be_sent(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~").find(c) != std::string_view::npos;
}

std::string checked_token(const std::string& text, const std::string& source) {
  if (text.size() < min_token_characters || text.size() > max_token_characters)
    throw InvalidInput(source, "holds a token of " + std::to_string(text.size()) + " characters: must be 16 to 96");
  if (!std::ranges::all_of(text, can_be_sent))
    throw InvalidInput(source, "holds a token with characters other than letters, digits and - . _ ~");
  return text;
}

std::string without_white_space(const std::string& text) {
  constexpr auto white = " \t\r\n";
  const auto first = text.find_first_not_of(white);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::string read_token_file(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream content;
  if (!file || !(content << file.rdbuf()))
    throw InvalidInput("token_file", "\"" + path + "\" cannot be read or is empty: " + std::strerror(errno));
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && (status.st_mode & S_IROTH))
    log::warn("{} can be read by every user of this machine: chmod 600 it", path);
  return checked_token(without_white_space(content.str()), "token_file \"" + path + "\"");
}

// "host" of "host:port", "[v6]:port".
std::string_view without_port(std::string_view host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

std::string_view without_scheme(std::string_view origin) {
  const auto slashes = origin.find("://");
  return slashes == std::string_view::npos ? origin : origin.substr(slashes + 3);
}

}  // namespace

Token choose_token(const settings::ServerSettings& settings, const Endpoint& endpoint) {
  if (!settings.token_file.empty()) return {read_token_file(settings.token_file), false};
  if (const char* given = std::getenv("CLOUDSCAPE_TOKEN"); given && *given)
    return {checked_token(given, "CLOUDSCAPE_TOKEN"), false};
  if (endpoint.loopback || settings.insecure) return {};
  return {random_hex(), true};
}

Authorization::Authorization(Token token, bool loopback, std::vector<std::string> allowed_origins)
    : token_(std::move(token)),
      check_host_(loopback && token_.text.empty()),
      allowed_origins_(std::move(allowed_origins)) {}

bool Authorization::accepts(const Request& request) const {
  if (token_.text.empty()) return true;
  const std::string_view header = request.authorization;
  if (header.size() > 7 && equal_without_case(header.substr(0, 7), "Bearer "))
    return equal_in_constant_time(trimmed(header.substr(7)), token_.text);
  return std::ranges::any_of(split_list(request.subprotocols), [&](std::string_view offered) {
    return offered.starts_with("bearer.") && equal_in_constant_time(offered.substr(7), token_.text);
  });
}

bool Authorization::accepts_origin(const Request& request) const {
  if (request.origin.empty() || lists_origin(request.origin)) return true;
  // Both schemes: behind a proxy that ends TLS the page's is https.
  return equal_without_case(request.origin, "http://" + request.host) ||
         equal_without_case(request.origin, "https://" + request.host);
}

bool Authorization::lists_origin(std::string_view origin) const {
  return std::ranges::any_of(allowed_origins_, [&](const auto& listed) { return equal_without_case(listed, origin); });
}

bool Authorization::accepts_host(std::string_view host) const {
  if (!check_host_) return true;
  for (const std::string_view name : {"localhost", "127.0.0.1", "[::1]"})
    if (equal_without_case(without_port(host), name)) return true;
  return std::ranges::any_of(allowed_origins_,
                             [&](const auto& listed) { return equal_without_case(without_scheme(listed), host); });
}

std::string random_hex() {
  unsigned char bytes[16];
  if (RAND_bytes(bytes, sizeof bytes) != 1) throw Error("This machine gives no random numbers.");
  std::string text;
  for (const unsigned char byte : bytes) text += "0123456789abcdef"[byte >> 4], text += "0123456789abcdef"[byte & 15];
  return text;
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace cloudscape::net
