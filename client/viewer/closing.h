// Why a connection failed or ended, and whether to try again.
#pragma once
#include <optional>
#include <string>

namespace cloudscape::viewer {

struct Closing {
  int http_status = 0;  // of the server's answer to the handshake; 0: none came
  int close_code = 0;   // of the WebSocket (RFC 6455, 7.4.1); 0: closed without one
  std::string reason;   // the peer's or the library's words
  bool was_open = false;
};

// A sentence for the person if trying again cannot help: the server understood and refused.
std::optional<std::string> refusal(const Closing& closing, const std::string& authority);

// A sentence for the log where it may help.
std::string describe(const Closing& closing, const std::string& authority);

}  // namespace cloudscape::viewer
