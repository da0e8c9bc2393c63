// Where the server listens: "HOST:PORT" to a numeric address, and whether that place is free.
#pragma once
#include <string>

namespace cloudscape::net {

struct Endpoint {
  std::string host;     // as given, without brackets
  std::string address;  // numeric
  int port = 0;         // 0: any
  bool ipv6 = false;
  bool loopback = false;
  bool any = false;  // every interface
};

// Throws InvalidInput ("listen ...") in one sentence; looks names up.
Endpoint parse_endpoint(const std::string& listen);
// Throws Error where another program listens there already or the address is not this machine's.
void check_free(const Endpoint& endpoint);
// "http://HOST:PORT/" that a browser on this machine opens.
std::string local_url(const Endpoint& endpoint, int port);

}  // namespace cloudscape::net
