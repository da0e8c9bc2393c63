#include "net/stream_socket.h"

#include <libwebsockets.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <vector>

#include "core/log.h"

namespace cloudscape::net {
namespace {

// A larger frame goes in parts, so that pings and closes need not wait behind it.
constexpr std::size_t part_bytes = 64 * 1024;
// Unsent bytes that the kernel may hold; more of them is only latency (measured: 143 ms instead of 1322 ms of age at
// 20 Mbit/s).
constexpr int unsent_bytes = 32 * 1024;
constexpr int hello_within_s = 5, close_within_s = 2;
constexpr std::size_t max_close_reason_bytes = 123;  // RFC 6455, 5.5

}  // namespace

StreamSocket::StreamSocket(Site& site, lws* wsi) : wsi_(wsi), session_(site, [wsi] { lws_callback_on_writable(wsi); }) {
  setsockopt(lws_get_socket_fd(wsi), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &unsent_bytes, sizeof unsent_bytes);
  lws_set_timer_usecs(wsi_, LWS_USEC_PER_SEC);
}

int StreamSocket::on_receive(std::string_view bytes) {
  if (lws_is_first_fragment(wsi_)) message_.clear();
  // libwebsockets has no limit: a frame that announces 2^40 bytes would be handed over piece by piece.
  if (!session_.closing() && message_.size() + bytes.size() > wire::max_client_message_bytes) {
    discarding_ = true;
    session_.on_oversize();
  }
  const bool complete = lws_is_final_fragment(wsi_);
  if (discarding_ && complete) {
    discarding_ = false;
    lws_callback_on_writable(wsi_);
  }
  if (session_.closing()) return 0;
  message_.append(bytes);
  if (complete) session_.on_message(message_, lws_frame_is_binary(wsi_), std::chrono::steady_clock::now());
  return 0;
}

int StreamSocket::on_writable() {
  if (close_sent_) return 0;  // closing again would hang up before the viewer has answered
  Outbox& outbox = session_.outbox();
  int result = 0;
  if (outbox.clock && outbox.texts.empty()) outbox.texts.push_back(*std::exchange(outbox.clock, std::nullopt));
  if (sending_)
    result = write_frame_part();
  else if (!outbox.texts.empty())
    result = write_text();
  else if (outbox.close && !discarding_)
    result = close_now();
  else if (outbox.frame)
    sending_ = std::exchange(outbox.frame, std::nullopt), sent_ = 0, result = write_frame_part();
  // While a message is discarded the close waits for its end, or for the timer: closing with unread bytes would make
  // the kernel send a reset, which can overtake the reason.
  const bool more = sending_ || !outbox.texts.empty() || outbox.clock || outbox.frame || (outbox.close && !discarding_);
  if (result == 0 && more) lws_callback_on_writable(wsi_);
  return result;
}

int StreamSocket::write_text() {
  const std::string text = std::move(session_.outbox().texts.front());
  session_.outbox().texts.pop_front();
  std::vector<unsigned char> buffer(LWS_PRE + text.size());
  std::ranges::copy(text, buffer.begin() + LWS_PRE);
  return lws_write(wsi_, buffer.data() + LWS_PRE, text.size(), LWS_WRITE_TEXT) < 0 ? -1 : 0;
}

// libwebsockets writes the part's own header in front of it, over bytes that have been sent already.
int StreamSocket::write_frame_part() {
  auto& bytes = sending_->frame.bytes;
  const std::size_t size = bytes.size() - sending_->first, part = std::min(size - sent_, part_bytes);
  const int flags = lws_write_ws_flags(LWS_WRITE_BINARY, sent_ == 0, sent_ + part == size);
  if (lws_write(wsi_, bytes.data() + sending_->first + sent_, part, static_cast<lws_write_protocol>(flags)) < 0)
    return -1;
  sent_ += part;
  if (sent_ < size) return 0;
  session_.on_sent(*sending_, std::chrono::steady_clock::now());
  sending_.reset();
  return 0;
}

int StreamSocket::close_now() {
  close_sent_ = true;
  auto [code, reason] = *session_.outbox().close;
  reason.resize(std::min(reason.size(), max_close_reason_bytes));
  lws_close_reason(wsi_, static_cast<lws_close_status>(code), reinterpret_cast<unsigned char*>(reason.data()),
                   reason.size());
  return -1;
}

int StreamSocket::on_timer() {
  if (close_sent_) return 0;
  if (session_.closing() && ++seconds_closing_ > close_within_s) return close_now();
  if (++seconds_ == hello_within_s) session_.on_hello_deadline();
  session_.on_second(std::chrono::steady_clock::now());
  lws_set_timer_usecs(wsi_, LWS_USEC_PER_SEC);
  return 0;
}

}  // namespace cloudscape::net
