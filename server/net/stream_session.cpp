#include "net/stream_session.h"

#include <nlohmann/json.hpp>

#include "core/log.h"
#include "core/version.h"
#include "net/metric_names.h"

namespace cloudscape::net {
namespace {

// RFC 6455, 7.4.1.
constexpr int going_away = 1001, policy_violation = 1008, message_too_big = 1009;

constexpr int max_errors = 20;  // tuned: a client with a bug is told so often enough, one that guesses is not

// Nothing that this viewer sends can be understood any more, or it does what the protocol forbids.
class Breach : public InvalidInput {
  using InvalidInput::InvalidInput;
};

// A number too large for a double (1e999) is JSON, and a bad value.
bool is_json(std::string_view text) {
  try {
    return !nlohmann::json::parse(text, nullptr, true, true).is_discarded();
  } catch (const nlohmann::json::out_of_range&) {
    return true;
  } catch (const nlohmann::json::parse_error&) {
    return false;
  }
}

}  // namespace

StreamSession::StreamSession(Site& site, std::function<void()> wake)
    : site_(site),
      wake_(std::move(wake)),
      messages_(site.parts.settings.messages_per_s, 2 * site.parts.settings.messages_per_s) {
  site_.sessions.insert(this);
  site_.parts.metrics.set(metric::sessions, static_cast<double>(site_.sessions.size()));
}

StreamSession::~StreamSession() {
  if (stream_) site_.parts.scheduler.close(*stream_);
  site_.sessions.erase(this);
  site_.parts.metrics.set(metric::sessions, static_cast<double>(site_.sessions.size()));
}

void StreamSession::on_message(std::string_view text, bool binary, Instant now) {
  if (closing()) return;
  site_.parts.metrics.count(metric::messages_in);
  if (!messages_.take(now))
    return close_with(policy_violation,
                      "Too many messages: at most " +
                          std::to_string(static_cast<int>(site_.parts.settings.messages_per_s)) +
                          " a second are read (messages_per_s).",
                      "flood");
  if (binary) return close_with(policy_violation, "Messages to the server are JSON text, not binary.", "binary");
  try {
    const auto& shown = viewed_.view;
    const wire::ClientMessage parsed =
        wire::parse_client_message(text, {shown.pose, shown.lens, shown.display, shown.march});
    if (const auto* hello = std::get_if<wire::Hello>(&parsed)) return receive(*hello, text, now);
    if (!stream_) throw Breach("/type", "must be \"hello\" in the first message");
    if (const auto* camera = std::get_if<wire::Camera>(&parsed)) return receive(*camera);
    if (const auto* settings = std::get_if<wire::Settings>(&parsed)) return receive(*settings, now);
    if (const auto* change = std::get_if<ClockChange>(&parsed)) return receive(*change, now);
    receive(std::get<wire::Ack>(parsed), now);
  } catch (const Error& error) {
    answer_error(error, text);
  }
}

void StreamSession::receive(const wire::Hello& hello, std::string_view text, Instant now) {
  if (stream_) throw Breach("", "A viewer says hello once.");
  if (hello.version != 1) throw Breach("/version", "must be 1");
  viewed_ = viewed_by(hello, text, site_.parts.cloudscapes, site_.parts.settings);
  set_time();
  stream_ = site_.parts.scheduler.open(viewed_.view);
  greet();
  tell_clock(now);
}

void StreamSession::greet() {
  const RendererInfo info = site_.renderer.value_or(RendererInfo{});
  const stream::StreamView& view = viewed_.view;
  const Sun& sun = view.cloudscape->sun;
  send(wire::Welcome{version, info.renderer, info.software, viewed_.name, view.pose, view.lens, view.display,
                     sun.azimuth_deg, sun.elevation_deg, view.size_px, max_stream_size_px(site_.parts.settings),
                     viewed_.document->sun.place.time_utc, sun.place.time_rate});
}

void StreamSession::receive(const wire::Settings& settings, Instant now) {
  viewed_ = changed(viewed_, settings, site_.parts.cloudscapes, site_.parts.settings);
  look();
  if (settings.cloudscape || settings.cloudscape_document) tell_clock(now);
}

void StreamSession::receive(const wire::Camera& camera) {
  viewed_.view.pose = camera.pose;
  viewed_.view.pose_sequence = camera.pose_sequence;
  if (camera.time_s) viewed_.view.time_s = *camera.time_s, viewed_.own_time = true;
  look();
}

// Of the document, so that all who look at it hear of the change.
void StreamSession::receive(const ClockChange& change, Instant now) {
  viewed_.own_time = false;
  clock().change(change, now);
  if (viewed_.name.empty()) return on_clock_changed(now);
  for (StreamSession* other : site_.sessions)
    if (other->stream_ && other->viewed_.name == viewed_.name) other->on_clock_changed(now);
}

void StreamSession::on_clock_changed(Instant now) {
  if (closing()) return;
  look();
  tell_clock(now);
}

stream::SharedClock& StreamSession::clock() { return viewed_.name.empty() ? own_clock_ : site_.clocks[viewed_.name]; }

void StreamSession::set_time() {
  viewed_.view.clock = viewed_.own_time ? std::nullopt : std::optional(clock().running());
}

void StreamSession::look() {
  set_time();
  site_.parts.scheduler.update(*stream_, viewed_.view);
}

void StreamSession::tell_clock(Instant now) {
  outbox_.clock = wire::to_text(clock().read(now));
  wake_();
}

void StreamSession::receive(const wire::Ack& ack, Instant now) {
  statistics_.acknowledged(ack.frame_id, now);
  site_.parts.scheduler.acknowledge(*stream_, ack.frame_id, ack.decode_ms);
}

void StreamSession::answer_error(const Error& error, std::string_view text) {
  const bool breach = dynamic_cast<const Breach*>(&error) || !is_json(text);
  const bool fatal = breach || ++errors_ > max_errors;
  const auto* invalid = dynamic_cast<const InvalidInput*>(&error);
  site_.parts.metrics.count(metric::message_errors);
  send(wire::ErrorMessage{error.what(), invalid ? invalid->pointer : "", fatal});
  if (fatal) close(policy_violation, breach ? "protocol" : "too many errors");
}

void StreamSession::on_oversize() {
  close_with(message_too_big, "A message has at most " + std::to_string(wire::max_client_message_bytes) + " bytes.",
             "message_size");
}

void StreamSession::on_hello_deadline() {
  if (!stream_) close_with(policy_violation, "No hello came within 5 seconds.", "hello");
}

void StreamSession::on_second(Instant now) {
  if (closing()) return;
  if (const auto stats = statistics_.take(now)) send(*stats);
}

void StreamSession::on_document_changed(const std::string& name) {
  if (!stream_ || closing() || viewed_.name != name) return;
  viewed_ = reloaded(viewed_, site_.parts.cloudscapes);
  look();
}

void StreamSession::offer(const stream::Work& work, const FrameTimings& timings, EncodedFrame frame) {
  if (closing() || frame.front < wire::frame_header_bytes) return;
  const std::size_t first = frame.front - wire::frame_header_bytes, image_bytes = frame.bytes.size() - frame.front;
  const wire::FrameHeader header =
      wire::frame_header(Frame{work.request, 0, {}, {}, {}, timings, {}}, work.frame_id, work.pose_sequence,
                         work.quality_stage, frame.encode_ms, image_bytes);
  wire::write(header,
              std::span<std::uint8_t, wire::frame_header_bytes>(frame.bytes.data() + first, wire::frame_header_bytes));
  if (outbox_.frame) {
    site_.parts.scheduler.dropped(work.request.stream, outbox_.frame->frame_id);
    site_.parts.metrics.count(metric::frames_dropped);
    statistics_.dropped();
  }
  outbox_.frame = OutgoingFrame{work.frame_id, std::move(frame), first, timings.render_ms};
  wake_();
}

void StreamSession::on_sent(const OutgoingFrame& frame, Instant now) {
  const std::size_t bytes = frame.frame.bytes.size() - frame.first;
  site_.parts.metrics.count(metric::frames_sent);
  site_.parts.metrics.count(metric::bytes_sent, static_cast<double>(bytes));
  statistics_.sent(frame.frame_id, bytes, frame.render_ms, frame.frame.encode_ms, now);
}

void StreamSession::fail(const std::string& message) {
  if (!closing()) send(wire::ErrorMessage{message, "", false});
}

void StreamSession::drain() {
  if (!closing()) close(going_away, "The server is stopping.");
}

void StreamSession::send(const wire::ServerMessage& message) {
  outbox_.texts.push_back(wire::to_text(message));
  // Only a viewer that reads nothing while it keeps asking for answers comes here.
  if (outbox_.texts.size() > 2 * max_errors && !closing()) close(policy_violation, "not reading");
  wake_();
}

void StreamSession::close_with(int code, const std::string& sentence, std::string_view reason) {
  if (closing()) return;
  site_.parts.metrics.count(metric::refused(reason));
  send(wire::ErrorMessage{sentence, "", true});
  close(code, sentence);
}

void StreamSession::close(int code, const std::string& reason) {
  if (stream_) site_.parts.scheduler.close(*stream_);
  stream_.reset();
  outbox_.frame.reset();
  outbox_.clock.reset();
  outbox_.close = {code, reason};
  wake_();
}

}  // namespace cloudscape::net
