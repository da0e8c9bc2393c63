// One WebSocket on libwebsockets: carries a StreamSession's messages and frames. Each on_... returns what the callback
// has to return: -1 closes the connection.
#pragma once
#include <optional>
#include <string>

#include "net/stream_session.h"

struct lws;

namespace cloudscape::net {

class StreamSocket {
 public:
  StreamSocket(Site& site, lws* wsi);
  StreamSession& session() { return session_; }

  int on_receive(std::string_view bytes);
  int on_writable();
  int on_timer();

 private:
  int write_text();
  int write_frame_part();
  int close_now();

  lws* wsi_;
  StreamSession session_;
  std::string message_;      // that is being received
  bool discarding_ = false;  // the rest of a message that is too long
  std::optional<OutgoingFrame> sending_;
  std::size_t sent_ = 0;  // of it
  int seconds_ = 0;
  int seconds_closing_ = 0;
  bool close_sent_ = false;
};

}  // namespace cloudscape::net
