#include "net/endpoint.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>

#include "core/error.h"

namespace cloudscape::net {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses look_up(const std::string& host, const std::string& port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICSERV | AI_PASSIVE;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(host.c_str(), port.c_str(), &hints, &found); error != 0)
    throw InvalidInput("listen", "names the host \"" + host + "\", which cannot be looked up: " + gai_strerror(error));
  return {found, freeaddrinfo};
}

int parse_port(const std::string& listen, const std::string& text) {
  int port = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size() || port < 0 || port > 65535)
    throw InvalidInput("listen", "is \"" + listen + "\": must end with a port from 0 to 65535, such as 127.0.0.1:8080");
  return port;
}

bool is_loopback(const sockaddr& address) {
  if (address.sa_family == AF_INET6)
    return IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
  return ntohl(reinterpret_cast<const sockaddr_in&>(address).sin_addr.s_addr) >> 24 == 127;
}

bool is_any(const sockaddr& address) {
  if (address.sa_family == AF_INET6)
    return IN6_IS_ADDR_UNSPECIFIED(&reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
  return reinterpret_cast<const sockaddr_in&>(address).sin_addr.s_addr == INADDR_ANY;
}

std::string bracketed(const std::string& address, bool ipv6) { return ipv6 ? '[' + address + ']' : address; }

std::string bind_error(const Endpoint& endpoint, int error) {
  const std::string place = bracketed(endpoint.address, endpoint.ipv6) + ':' + std::to_string(endpoint.port);
  if (error == EADDRINUSE)
    return "Another program listens on " + place + " already: stop it, or give another place with --listen HOST:PORT.";
  if (error == EACCES) return place + " needs more rights than this user has: give a port above 1023 with --listen.";
  return "Cannot listen on " + place + ": " + std::strerror(error) + '.';
}

}  // namespace

Endpoint parse_endpoint(const std::string& listen) {
  const auto colon = listen.rfind(':');
  Endpoint endpoint;
  endpoint.port = parse_port(listen, colon == std::string::npos ? "" : listen.substr(colon + 1));
  endpoint.host = listen.substr(0, colon);
  if (endpoint.host.starts_with('[') && endpoint.host.ends_with(']'))
    endpoint.host = endpoint.host.substr(1, endpoint.host.size() - 2);
  else if (endpoint.host.empty() || endpoint.host.find(':') != std::string::npos)
    throw InvalidInput("listen", "is \"" + listen + "\": must be HOST:PORT, an IPv6 address in brackets");
  const Addresses found = look_up(endpoint.host, std::to_string(endpoint.port));
  char numeric[NI_MAXHOST] = "";
  getnameinfo(found->ai_addr, found->ai_addrlen, numeric, sizeof numeric, nullptr, 0, NI_NUMERICHOST);
  endpoint.address = numeric;
  endpoint.ipv6 = found->ai_family == AF_INET6;
  endpoint.loopback = is_loopback(*found->ai_addr);
  endpoint.any = is_any(*found->ai_addr);
  return endpoint;
}

void check_free(const Endpoint& endpoint) {
  const Addresses found = look_up(endpoint.address, std::to_string(endpoint.port));
  const int descriptor = socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) throw Error(bind_error(endpoint, errno));
  const int on = 1;
  setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const bool free = bind(descriptor, found->ai_addr, found->ai_addrlen) == 0 && ::listen(descriptor, 1) == 0;
  const int error = errno;
  ::close(descriptor);
  if (!free) throw Error(bind_error(endpoint, error));
}

std::string local_url(const Endpoint& endpoint, int port) {
  const std::string wildcard = endpoint.ipv6 ? "::1" : "127.0.0.1";
  const std::string host = endpoint.any ? wildcard : endpoint.host;
  const bool brackets = host.find(':') != std::string::npos;
  return "http://" + bracketed(host, brackets) + ':' + std::to_string(port) + '/';
}

}  // namespace cloudscape::net
