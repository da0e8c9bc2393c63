// One WebSocket connection at a time to one server, over libwebsockets on a thread of its own.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/closing.h"
#include "viewer/endpoint.h"

namespace cloudscape::viewer {

// What happens on the link; all of it is called on the link's thread.
class LinkEvents {
 public:
  virtual ~LinkEvents() = default;
  virtual void opened() = 0;
  virtual void received_text(const std::string& text) = 0;
  virtual void received_binary(std::vector<std::uint8_t> message) = 0;
  virtual std::optional<std::string> next_text() = 0;                // to send; asked again until there is none
  virtual std::optional<double> closed(const Closing& closing) = 0;  // seconds until the next attempt; nullopt: none
};

class Link {
 public:
  Link(const Endpoint& endpoint, LinkEvents& events);  // connects at once
  ~Link();                                             // closes with 1000 and joins
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  void wake();  // from any thread: events.next_text() has something

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cloudscape::viewer
