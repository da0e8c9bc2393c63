// One viewer: what its messages do, and what it is sent. No sockets; stream_socket.h carries it.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "net/limits.h"
#include "net/outbox.h"
#include "net/site.h"
#include "net/stream_statistics.h"
#include "net/viewed.h"

namespace cloudscape::net {

class StreamSession {
 public:
  // `wake` is called when the outbox has something new.
  StreamSession(Site& site, std::function<void()> wake);
  ~StreamSession();
  StreamSession(const StreamSession&) = delete;

  void on_message(std::string_view text, bool binary, Instant now);
  void on_oversize();        // the message in progress has more bytes than are read
  void on_hello_deadline();  // closes a viewer that has not said hello
  void on_second(Instant now);
  void on_document_changed(const std::string& name);
  void on_clock_changed(Instant now);  // of the document that it looks at
  void offer(const stream::Work& work, const FrameTimings& timings, EncodedFrame frame);
  void on_sent(const OutgoingFrame& frame, Instant now);  // the socket took the last byte of it
  void fail(const std::string& message);
  void drain();

  std::optional<StreamId> stream() const { return stream_; }
  bool closing() const { return outbox_.close.has_value(); }
  Outbox& outbox() { return outbox_; }

 private:
  void receive(const wire::Hello& hello, std::string_view text, Instant now);
  void receive(const wire::Settings& settings, Instant now);
  void receive(const wire::Camera& camera);
  void receive(const wire::Ack& ack, Instant now);
  void receive(const ClockChange& change, Instant now);
  void greet();
  stream::SharedClock& clock();
  void set_time();  // of the view, by the clock or by itself
  void tell_clock(Instant now);
  void look();
  void send(const wire::ServerMessage& message);
  void answer_error(const Error& error, std::string_view text);
  void close_with(int code, const std::string& sentence, std::string_view reason);
  void close(int code, const std::string& reason);

  Site& site_;
  std::function<void()> wake_;
  TokenBucket messages_;
  Outbox outbox_;
  std::optional<StreamId> stream_;  // after hello
  Viewed viewed_;
  stream::SharedClock own_clock_;  // of a document without a name
  StreamStatistics statistics_;
  int errors_ = 0;
};

}  // namespace cloudscape::net
