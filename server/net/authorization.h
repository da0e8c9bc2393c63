// Who may use the server: a token where one is needed, and which Origin and Host are ours.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "net/endpoint.h"
#include "net/http_request.h"
#include "settings/server_settings.h"

namespace cloudscape::net {

// The token of this process; empty where none is needed. From settings.token_file, else from the environment
// (CLOUDSCAPE_TOKEN), else made where the server listens beyond loopback and is not told to be insecure.
struct Token {
  std::string text;
  bool made = false;  // nobody knows it but who reads the ready link
};
// Throws Error or InvalidInput in one sentence for a token that is absent, too short or not sendable.
Token choose_token(const settings::ServerSettings& settings, const Endpoint& endpoint);

class Authorization {
 public:
  Authorization(Token token, bool loopback, std::vector<std::string> allowed_origins);
  const Token& token() const { return token_; }
  // "Bearer TOKEN" in the header, or "bearer.TOKEN" among the offered subprotocols. True where no token is needed.
  bool accepts(const Request& request) const;
  // Absent (a native client), of the same host and port as the request, or listed.
  bool accepts_origin(const Request& request) const;
  // An Origin of another site that is listed: the one that gets CORS headers.
  bool lists_origin(std::string_view origin) const;
  // Without a token a loopback server answers only to loopback names: else any web page could reach it by a name that
  // it makes resolve to 127.0.0.1 (DNS rebinding).
  bool accepts_host(std::string_view host) const;

 private:
  Token token_;
  bool check_host_;
  std::vector<std::string> allowed_origins_;
};

std::string random_hex();  // 128 bits of the operating system's, as 32 digits
bool equal_in_constant_time(std::string_view a, std::string_view b);  // the lengths may be told

}  // namespace cloudscape::net
