#include "net/http_connection.h"

#include <libwebsockets.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "net/handshake.h"
#include "net/header_list.h"
#include "net/lws_request.h"
#include "net/metric_names.h"
#include "net/problem.h"

namespace cloudscape::net {
namespace {

constexpr std::size_t chunk_bytes = 64 * 1024;  // one lws_write; others get their turn between two
// tuned: how soon a client that left is noticed, against how often each waiting connection is looked at.
constexpr lws_usec_t look_us = 200'000;
// A client that reads slower than this on the whole is hung up on. tuned: well below a bad mobile link.
constexpr double min_bytes_per_s = 16 * 1024, write_grace_s = 20;

constexpr Instant::duration seconds(double s) {
  return std::chrono::duration_cast<Instant::duration>(std::chrono::duration<double>(s));
}

}  // namespace

HttpConnection::~HttpConnection() {
  if (stage_ == Stage::waiting) site_.stills.leave(waiter_);
}

int HttpConnection::on_request() {
  request_ = copy_request(wsi_);
  body_unread_ = has_body(request_);
  if (auto refused = refuse_early(site_, router_, request_)) return respond(*refused);
  return body_unread_ ? read_body() : ask();
}

int HttpConnection::read_body() {
  stage_ = Stage::body;
  set_deadline(site_.parts.settings.body_timeout_s);  // for the whole body: a byte now and then does not extend it
  if (equal_without_case(request_.expect, "100-continue")) send_now("HTTP/1.1 100 Continue\r\n\r\n");
  return 0;
}

int HttpConnection::on_body(std::string_view bytes) {
  if (stage_ == Stage::body) request_.body.append(bytes);
  return 0;
}

int HttpConnection::on_body_complete() {
  if (stage_ == Stage::lingering) return -1;
  if (stage_ != Stage::body) return 0;
  body_unread_ = false;
  return ask();
}

int HttpConnection::ask() {
  const Answer given = answer(site_, router_, request_);
  if (const auto* response = std::get_if<Response>(&given)) return respond(*response);
  wait(std::get<Pending>(given).waiter);
  return 0;
}

// While a picture is rendered nothing is read: libwebsockets would neither take the bytes of a pipelined request nor
// stop polling for them, at the cost of a core.
void HttpConnection::wait(std::uint64_t waiter) {
  stage_ = Stage::waiting;
  waiter_ = waiter;
  lws_set_timeout(wsi_, NO_PENDING_TIMEOUT, 0);
  lws_rx_flow_control(wsi_, 0);
  set_deadline(site_.parts.settings.still_timeout_s);
}

void HttpConnection::on_answer(Response answer) {
  lws_rx_flow_control(wsi_, 1);
  respond(std::move(answer));
}

int HttpConnection::respond(Response response) {
  response_ = finished(site_, router_, request_, std::move(response));
  response_.close |=
      body_unread_ || request_.version != "HTTP/1.1" || has_token(request_.connection, "close") || site_.draining;
  head_ = head_text(response_);
  sent_ = 0;
  size_ = head_.size() + (request_.method == Method::head ? 0 : response_.body.bytes.size());
  stage_ = Stage::writing;
  lws_set_timeout(wsi_, NO_PENDING_TIMEOUT, 0);
  set_deadline(write_grace_s + static_cast<double>(size_) / min_bytes_per_s);
  lws_callback_on_writable(wsi_);
  return 0;
}

int HttpConnection::on_writable() {
  if (stage_ != Stage::writing) return 0;
  if (sent_ == size_) return finish();
  static thread_local std::array<unsigned char, LWS_PRE + chunk_bytes> buffer;
  const std::size_t bytes = copy_chunk({reinterpret_cast<char*>(buffer.data()) + LWS_PRE, chunk_bytes});
  if (lws_write(wsi_, buffer.data() + LWS_PRE, bytes, LWS_WRITE_HTTP) < 0) return -1;
  sent_ += bytes;
  // What the socket did not take is with libwebsockets, which calls again when it is through.
  if (sent_ == size_ && !lws_partial_buffered(wsi_)) return finish();
  lws_callback_on_writable(wsi_);
  return 0;
}

// The next bytes of head and body into `room`; returns how many.
std::size_t HttpConnection::copy_chunk(std::span<char> room) const {
  std::size_t bytes = sent_ < head_.size() ? head_.copy(room.data(), room.size(), sent_) : 0;
  const std::size_t body_sent = sent_ + bytes - head_.size();
  const std::size_t body_left = size_ - sent_ - bytes;
  return bytes + response_.body.bytes.substr(0, body_sent + body_left)
                     .copy(room.data() + bytes, room.size() - bytes, body_sent);
}

int HttpConnection::finish() {
  stage_ = Stage::idle;
  lws_set_timer_usecs(wsi_, LWS_SET_TIMER_USEC_CANCEL);
  site_.parts.metrics.count(metric::bytes_sent, static_cast<double>(size_));
  const bool close = response_.close;
  response_ = {};
  request_ = {};
  if (body_unread_) return linger();
  return close || lws_http_transaction_completed(wsi_) ? -1 : 0;
}

// Closing with unread bytes would make the kernel send a reset, which can overtake the answer. So the rest of the body
// is read and thrown away until the client has read the answer and closes, or its time is over.
int HttpConnection::linger() {
  stage_ = Stage::lingering;
  ::shutdown(lws_get_socket_fd(wsi_), SHUT_WR);
  set_deadline(site_.parts.settings.body_timeout_s);
  return 0;
}

int HttpConnection::on_timer() {
  const bool late = std::chrono::steady_clock::now() >= deadline_;
  if (stage_ == Stage::idle) return 0;
  if (stage_ == Stage::lingering || stage_ == Stage::writing) {
    if (late || (stage_ == Stage::writing && pending_input() != Input::none)) return -1;
  } else if (stage_ == Stage::body && late) {
    return respond(problem(408, "The body did not arrive within " +
                                    std::to_string(static_cast<int>(site_.parts.settings.body_timeout_s)) + " s."));
  } else if (stage_ == Stage::waiting) {
    return on_waiting_timer(late);
  }
  lws_set_timer_usecs(wsi_, look_us);
  return 0;
}

// Only the socket can tell: libwebsockets does not read while a request waits for its answer.
int HttpConnection::on_waiting_timer(bool late) {
  if (pending_input() == Input::ended) return -1;
  if (late) {
    site_.stills.leave(waiter_);
    on_answer(busy(503,
                   "The still took longer than " +
                       std::to_string(static_cast<int>(site_.parts.settings.still_timeout_s)) +
                       " s (still_timeout_s): ask for less, or later.",
                   5));
    return 0;
  }
  lws_set_timer_usecs(wsi_, look_us);
  return 0;
}

HttpConnection::Input HttpConnection::pending_input() const {
  char byte = 0;
  const auto got = ::recv(lws_get_socket_fd(wsi_), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  if (got > 0) return Input::more;
  return got < 0 && (errno == EAGAIN || errno == EINTR) ? Input::none : Input::ended;
}

void HttpConnection::set_deadline(double s) {
  deadline_ = std::chrono::steady_clock::now() + seconds(s);
  lws_set_timer_usecs(wsi_, look_us);
}

bool HttpConnection::send_now(std::string_view text) const {
  std::vector<unsigned char> buffer(LWS_PRE + text.size());
  std::ranges::copy(text, buffer.begin() + LWS_PRE);
  return lws_write(wsi_, buffer.data() + LWS_PRE, text.size(), LWS_WRITE_HTTP) >= 0;
}

int HttpConnection::on_upgrade() {
  // A value that libwebsockets does not know: it has answered 403 and given its header table away already, so that
  // going on, or touching its pointer to the value, would use freed memory (CVE-2025-11677).
  char upgrade[32] = "";
  if (lws_hdr_copy(wsi_, upgrade, sizeof upgrade, WSI_TOKEN_UPGRADE) <= 0) return -1;
  request_ = copy_request(wsi_);
  std::optional<Response> refused;
  if (equal_without_case(upgrade, "websocket"))
    refused = refuse_upgrade(request_, site_);
  else  // h2c: letting it pass would open libwebsockets' HTTP/2 on the cleartext port
    refused = problem(400, "This server speaks HTTP/1.1 and WebSocket: leave the Upgrade header out.");
  if (!refused) return 0;
  refused->close = true;
  const Response response = finished(site_, router_, request_, *refused);
  send_now(head_text(response).append(response.body.bytes));
  return -1;
}

}  // namespace cloudscape::net
