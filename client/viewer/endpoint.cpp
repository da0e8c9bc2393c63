// Addresses, split by libwebsockets' own parser.
#include "viewer/endpoint.h"

#include <libwebsockets.h>

#include <string_view>

#include "core/error.h"

namespace cloudscape::viewer {
namespace {

constexpr std::string_view stream_path = "/api/v1/stream";

[[noreturn]] void refuse(const std::string& url, const std::string& why) {
  throw InvalidInput("URL", "is '" + url + "', which " + why + ": give ws://HOST:PORT, such as ws://127.0.0.1:8080");
}

// "/prefix/" -> "/prefix/api/v1/stream"; the whole path is taken as it is.
std::string path_of_stream(std::string path) {
  path.erase(path.find_last_not_of('/') + 1);
  return path.ends_with(stream_path) ? path : path + std::string(stream_path);
}

}  // namespace

Endpoint parse_endpoint(const std::string& url) {
  const std::string fragment_key = "#token=";
  const std::size_t fragment = std::min(url.find('#'), url.size());
  Endpoint endpoint;
  if (url.substr(fragment).starts_with(fragment_key)) endpoint.token = url.substr(fragment + fragment_key.size());

  std::string address = url.substr(0, fragment);  // the parser writes into it
  if (address.find("://") == std::string::npos) refuse(url, "names no protocol");
  const char *protocol = nullptr, *host = nullptr, *path = nullptr;
  if (lws_parse_uri(address.data(), &protocol, &host, &endpoint.port, &path) != 0) refuse(url, "is no address");
  const std::string_view scheme = protocol;
  if (scheme != "ws" && scheme != "wss" && scheme != "http" && scheme != "https") refuse(url, "names another protocol");
  if (*host == '\0') refuse(url, "names no host");
  if (endpoint.port < 1 || endpoint.port > 65535) refuse(url, "names a port outside 1 to 65535");
  endpoint.tls = scheme == "wss" || scheme == "https";
  endpoint.host = host;
  endpoint.path = path_of_stream(std::string("/") + path);
  return endpoint;
}

std::string authority(const Endpoint& endpoint) {
  const bool ipv6 = endpoint.host.find(':') != std::string::npos;
  return (ipv6 ? "[" + endpoint.host + "]" : endpoint.host) + ":" + std::to_string(endpoint.port);
}

}  // namespace cloudscape::viewer
