// What waits to be sent: never more than one camera and one set of settings, and always enough to ask for the same view
// again after a reconnection.
#pragma once
#include <deque>
#include <optional>

#include "wire/messages.h"

namespace cloudscape::viewer {

class Outbox {
 public:
  explicit Outbox(wire::Settings start);  // what the first hello asks for

  void connected();     // a hello is due, and after it the newest camera
  void disconnected();  // acknowledgements of the lost connection's frames mean nothing to the next one
  void look(const wire::Camera& camera);        // the newest wins
  void change(const wire::Settings& settings);  // the newest of each member wins
  void turn(const ClockChange& change);         // the newest of each member wins
  void acknowledge(const wire::Ack& ack);
  std::optional<wire::ClientMessage> next();  // hello, then acknowledgements, settings, clock, camera

 private:
  wire::Settings view_;  // all that was asked for so far
  bool hello_due_ = false, connected_ = false;
  std::optional<wire::Settings> settings_;
  std::optional<ClockChange> clock_;
  std::optional<wire::Camera> newest_camera_;
  bool camera_due_ = false;
  std::deque<wire::Ack> acks_;
};

// `into` with the members that `changes` has.
void merge(wire::Settings& into, const wire::Settings& changes);

}  // namespace cloudscape::viewer
