// The stream as the rest of the viewer sees it: what to look at goes in, decoded pictures come out. It connects, comes
// back with the same view when the connection is lost, and gives up where the server refuses.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "viewer/endpoint.h"
#include "viewer/picture.h"
#include "wire/messages.h"

namespace cloudscape::viewer {

struct StreamStatus {
  bool connected = false;
  std::optional<wire::Welcome> welcome;  // the last connection's
  wire::Stats stats;
  ClockState clock;  // as it was last told
  Time clock_told{};
  std::string notice;  // the last complaint of server or network, "" after a picture
  unsigned connections = 0;
  std::uint64_t frames_received = 0, bytes_received = 0;
  std::uint64_t frames_skipped = 0;  // replaced by newer ones before they were decoded
  std::uint64_t frames_broken = 0;
};

class StreamClient {
 public:
  // `news` is called on other threads when a picture can be taken or the status has changed. With `patience_s` a stream
  // without a connection for so long fails; 0: it tries for ever, once it was connected.
  StreamClient(const Endpoint& endpoint, const wire::Settings& start, double patience_s, std::function<void()> news);
  ~StreamClient();

  // The pose's sequence number, from 1 on. Without a time the picture is that of the document's clock.
  std::uint64_t look(const CameraPose& pose, std::optional<double> time_s = {});
  void change(const wire::Settings& settings);
  void turn_clock(const ClockChange& change);  // of the document, for all who look at it
  // The newest decoded picture, if there is one before `deadline`. At most one more is decoded and one received ahead.
  std::optional<Picture> take_picture(Time deadline);
  void displayed(const Picture& picture);  // acknowledges it; call it once it is on display
  StreamStatus status() const;
  std::optional<std::string> failure() const;  // the sentence, once the stream will not come back

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cloudscape::viewer
