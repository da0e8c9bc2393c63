// Where the stream is, from the address that a person types or copies.
#pragma once
#include <string>

namespace cloudscape::viewer {

struct Endpoint {
  std::string host;  // without brackets
  int port = 0;
  bool tls = false;
  std::string path;   // "/api/v1/stream", behind the path of the address if it has one
  std::string token;  // "": none
  bool operator==(const Endpoint&) const = default;
};

// ws://HOST:PORT, wss://, and the http:// or https:// link that the server prints, its #token=... included. Throws
// InvalidInput.
Endpoint parse_endpoint(const std::string& url);

// HOST:PORT for headers and messages, an IPv6 address in brackets.
std::string authority(const Endpoint& endpoint);

}  // namespace cloudscape::viewer
