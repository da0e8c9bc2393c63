// What waits for one viewer's socket: messages in order, and of clocks and frames only the newest.
#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/frame.h"

namespace cloudscape::net {

struct OutgoingFrame {
  std::uint32_t frame_id = 0;
  EncodedFrame frame;
  std::size_t first =
      0;  // where the message starts in frame.bytes: its header is written, room for the socket's before
  double render_ms = 0;
};

struct Outbox {
  struct Close {
    int code = 1000;
    std::string reason;
  };
  std::deque<std::string> texts;
  std::optional<std::string> clock;  // what was last to be told of it
  std::optional<OutgoingFrame> frame;
  std::optional<Close> close;  // after the texts
};

}  // namespace cloudscape::net
