// The link's thread fills a slot with the newest frame, the decoder's thread turns it into a picture, the owner takes
// it.
#include "viewer/stream_client.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "core/error.h"
#include "core/log.h"
#include "viewer/back_off.h"
#include "viewer/link.h"
#include "viewer/outbox.h"

namespace cloudscape::viewer {
namespace {

constexpr double first_patience_s = 15.0;  // tuned: a server that bakes at its start listens by then

Time now() { return std::chrono::steady_clock::now(); }

}  // namespace

struct StreamClient::State : LinkEvents {
  State(const Endpoint& where, const wire::Settings& start, double patience, std::function<void()> on_news)
      : authority(viewer::authority(where)), patience_s(patience), news(std::move(on_news)), outbox(start) {}

  // Of LinkEvents, on the link's thread.
  void opened() override {
    const std::lock_guard lock(mutex);
    status.connected = true;
    ++status.connections;
    welcomed = false;
    outbox.connected();
  }

  void received_text(const std::string& text) override {
    try {
      const wire::ServerMessage message = wire::parse_server_message(text);
      const std::lock_guard lock(mutex);
      std::visit([this](const auto& value) { take_message(value); }, message);
    } catch (const std::exception& error) {
      log::warn("A message of the server cannot be read: {}", error.what());
    }
    tell();
  }

  void take_message(const wire::Welcome& welcome) {
    status.welcome = welcome;
    welcomed = true;
    back_off.reset();
  }
  void take_message(const wire::Stats& stats) { status.stats = stats; }
  void take_message(const ClockState& clock) { status.clock = clock, status.clock_told = now(); }
  // What a server says before its welcome answers the hello, which would be the same the next time.
  void take_message(const wire::ErrorMessage& error) {
    if (error.fatal || !welcomed)
      failure = "The server at " + authority + " refused: " + error.message;
    else
      status.notice = error.message;
  }

  void received_binary(std::vector<std::uint8_t> message) override {
    try {
      ReceivedFrame frame{wire::read_frame_header(message), std::move(message), 0};
      const std::lock_guard lock(mutex);
      frame.connection = status.connections;
      status.frames_received += 1;
      status.bytes_received += frame.message.size();
      if (received) {
        outbox.acknowledge({received->header.frame_id, 0});
        status.frames_skipped += 1;
      }
      received = std::move(frame);
    } catch (const std::exception& error) {
      log::warn("A frame of the server cannot be read: {}", error.what());
    }
    changed.notify_all();
  }

  std::optional<std::string> next_text() override {
    const std::lock_guard lock(mutex);
    const std::optional<wire::ClientMessage> message = outbox.next();
    return message ? std::optional(wire::to_text(*message)) : std::nullopt;
  }

  std::optional<double> closed(const Closing& closing) override {
    std::optional<double> delay_s;
    {
      const std::lock_guard lock(mutex);
      if (std::exchange(status.connected, false)) lost = now();
      outbox.disconnected();
      received.reset();
      status.notice = describe(closing, authority);
      if (!failure) failure = refusal(closing, authority);
      if (!failure && out_of_patience()) failure = status.notice;
      if (!failure) delay_s = back_off.next_s();
    }
    if (delay_s) log::info("{} Next attempt in {:.1f} s.", describe(closing, authority), *delay_s);
    tell();
    return delay_s;
  }

  bool out_of_patience() const {
    const double without_s = milliseconds_between(lost, now()) / 1000.0;
    if (status.connections == 0) return without_s > (patience_s > 0 ? patience_s : first_patience_s);
    return patience_s > 0 && without_s > patience_s;
  }

  void tell() {
    changed.notify_all();
    news();
  }

  // The decoder's thread.
  void decode_frames() {
    JpegDecoder jpeg;
    std::unique_lock lock(mutex);
    for (;;) {
      changed.wait(lock, [this] { return stopping || (received && !decoded); });
      if (stopping) return;
      ReceivedFrame frame = *std::exchange(received, std::nullopt);
      const wire::Ack unseen{frame.header.frame_id, 0};
      const unsigned connection = frame.connection;
      lock.unlock();
      std::optional<Picture> picture = decode(jpeg, std::move(frame));
      lock.lock();
      if (picture)
        status.notice.clear();
      else
        status.frames_broken += 1;
      if (!picture && connection == status.connections) outbox.acknowledge(unseen);
      decoded = std::move(picture);
      lock.unlock();
      tell();
      link->wake();
      lock.lock();
    }
  }

  static std::optional<Picture> decode(JpegDecoder& jpeg, ReceivedFrame frame) {
    try {
      return jpeg.decode(std::move(frame));
    } catch (const Error& error) {
      log::warn("{}", error.what());
      return std::nullopt;
    }
  }

  const std::string authority;
  const double patience_s;
  const std::function<void()> news;
  mutable std::mutex mutex;
  std::condition_variable changed;
  Outbox outbox;
  BackOff back_off{random_uniform()};
  StreamStatus status;
  std::optional<std::string> failure;
  bool welcomed = false, stopping = false;
  Time lost = now();
  std::uint64_t pose_sequence = 0;
  std::optional<ReceivedFrame> received;
  std::optional<Picture> decoded;
  std::thread decoder;
  std::optional<Link> link;
};

StreamClient::StreamClient(const Endpoint& endpoint, const wire::Settings& start, double patience_s,
                           std::function<void()> news)
    : state_(std::make_unique<State>(endpoint, start, patience_s, std::move(news))) {
  state_->link.emplace(endpoint, *state_);
  state_->decoder = std::thread([this] { state_->decode_frames(); });
}

StreamClient::~StreamClient() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
  }
  state_->changed.notify_all();
  state_->decoder.join();
  state_->link.reset();
}

std::uint64_t StreamClient::look(const CameraPose& pose, std::optional<double> time_s) {
  std::uint64_t sequence = 0;
  {
    const std::lock_guard lock(state_->mutex);
    sequence = ++state_->pose_sequence;
    state_->outbox.look({sequence, pose, time_s});
  }
  state_->link->wake();
  return sequence;
}

void StreamClient::change(const wire::Settings& settings) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->outbox.change(settings);
  }
  state_->link->wake();
}

void StreamClient::turn_clock(const ClockChange& change) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->outbox.turn(change);
  }
  state_->link->wake();
}

std::optional<Picture> StreamClient::take_picture(Time deadline) {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait_until(lock, deadline, [this] { return state_->decoded || state_->failure; });
  std::optional<Picture> picture = std::exchange(state_->decoded, std::nullopt);
  lock.unlock();
  state_->changed.notify_all();  // the decoder has room again
  return picture;
}

void StreamClient::displayed(const Picture& picture) {
  {
    const std::lock_guard lock(state_->mutex);
    if (picture.frame.connection != state_->status.connections) return;
    state_->outbox.acknowledge({picture.frame.header.frame_id, picture.decode_ms});
  }
  state_->link->wake();
}

StreamStatus StreamClient::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

std::optional<std::string> StreamClient::failure() const {
  const std::lock_guard lock(state_->mutex);
  return state_->failure;
}

}  // namespace cloudscape::viewer
