// The WebSocket client. Of libwebsockets' calls only lws_cancel_service may come from another thread.
#include "viewer/link.h"

#include <libwebsockets.h>

#include <array>
#include <atomic>
#include <cstring>
#include <string_view>
#include <thread>

#include "core/error.h"
#include "core/log.h"
#include "viewer/message_assembly.h"
#include "wire/messages.h"

namespace cloudscape::viewer {
namespace {

constexpr lws_usec_t drain_us = 1'000'000;  // tuned: long enough for a close frame to cross the world and back

// A ping after 10 s of silence, and the connection counts as dead after 20 s.
const lws_retry_bo_t liveness{nullptr, 0, 0, 10, 20, 0};

void log_line(int level, const char* line) {
  std::string_view text = line;
  while (text.ends_with('\n')) text.remove_suffix(1);
  level == LLL_ERR ? log::warn("{}", text) : log::debug("{}", text);
}

std::string to_string(const void* in, std::size_t length) {
  return in ? std::string(static_cast<const char*>(in), length) : std::string();
}

}  // namespace

struct Link::State {
  State(const Endpoint& where, LinkEvents& what) : endpoint(where), events(what) {
    lws_set_log_level(LLL_ERR | LLL_WARN, log_line);
    lws_context_creation_info info{};
    info.port = CONTEXT_PORT_NO_LISTEN;
    info.protocols = protocols.data();
    info.user = this;
    info.retry_and_idle_policy = &liveness;
    info.options = endpoint.tls ? LWS_SERVER_OPTION_DO_SSL_GLOBAL_INIT : 0;
    context = lws_create_context(&info);
    if (!context) throw Error("The network cannot be used: libwebsockets did not start.");
    timer.state = this;
    thread = std::thread([this] { run(); });
  }

  void run() {
    connect();
    while (!stopping || (open && !drained)) lws_service(context, 0);
  }

  void connect() {
    const std::string host = authority(endpoint);
    const std::string protocol(wire::subprotocol);
    lws_client_connect_info info{};
    info.context = context;
    info.address = endpoint.host.c_str();
    info.port = endpoint.port;
    info.path = endpoint.path.c_str();
    info.host = host.c_str();
    info.protocol = protocol.c_str();
    info.local_protocol_name = protocols[0].name;
    info.ssl_connection = endpoint.tls ? LCCSCF_USE_SSL : 0;
    info.pwsi = &wsi;
    connecting = true;
    if (!lws_client_connect_via_info(&info) && connecting) failed("it cannot be reached", nullptr);
  }

  void failed(const std::string& reason, lws* failing) {
    connecting = false;
    Closing closing;
    closing.reason = reason;
    closing.http_status = failing ? static_cast<int>(lws_http_client_http_response(failing)) : 0;
    ended(closing);
  }

  void ended(const Closing& closing) {
    wsi = nullptr;
    open = false;
    assembly = {};
    if (stopping) return;
    if (const std::optional<double> delay_s = events.closed(closing))
      lws_sul_schedule(context, 0, &timer.sul, on_timer, static_cast<lws_usec_t>(*delay_s * 1e6));
  }

  int append_token(lws* handshake, unsigned char** position, unsigned char* end) {
    if (endpoint.token.empty()) return 0;
    const std::string value = "Bearer " + endpoint.token;
    return lws_add_http_header_by_token(handshake, WSI_TOKEN_HTTP_AUTHORIZATION,
                                        reinterpret_cast<const unsigned char*>(value.data()),
                                        static_cast<int>(value.size()), position, end);
  }

  int receive(const void* in, std::size_t length) {
    const bool more = lws_remaining_packet_payload(wsi) != 0 || !lws_is_final_fragment(wsi);
    if (!assembly.append({static_cast<const std::uint8_t*>(in), length}, more))
      return close(LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE);
    if (more) return 0;
    std::vector<std::uint8_t> message = assembly.take();
    if (lws_frame_is_binary(wsi))
      events.received_binary(std::move(message));
    else
      events.received_text(std::string(message.begin(), message.end()));
    lws_callback_on_writable(wsi);
    return 0;
  }

  // One message a callback: libwebsockets allows no second write before the socket took the first.
  int send() {
    const std::optional<std::string> text = events.next_text();
    if (!text) return stopping ? close(LWS_CLOSE_STATUS_NORMAL) : 0;
    std::vector<unsigned char> buffer(LWS_PRE + text->size());
    std::memcpy(buffer.data() + LWS_PRE, text->data(), text->size());
    if (lws_write(wsi, buffer.data() + LWS_PRE, text->size(), LWS_WRITE_TEXT) < 0) return -1;
    lws_callback_on_writable(wsi);
    return 0;
  }

  int close(lws_close_status status) {
    lws_close_reason(wsi, status, nullptr, 0);
    return -1;
  }

  void peer_closes(const void* in, std::size_t length) {
    if (length < 2) return;
    const auto* bytes = static_cast<const unsigned char*>(in);
    last.close_code = bytes[0] << 8 | bytes[1];
    last.reason = to_string(bytes + 2, length - 2);
  }

  int handle(lws* caller, lws_callback_reasons what, void* in, std::size_t length) {
    switch (what) {
      case LWS_CALLBACK_CLIENT_APPEND_HANDSHAKE_HEADER: {
        auto** position = static_cast<unsigned char**>(in);
        return append_token(caller, position, *position + length);
      }
      case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
        failed(to_string(in, length), caller);
        return 0;
      case LWS_CALLBACK_CLIENT_ESTABLISHED:
        connecting = false;
        open = true;
        last = Closing{};
        last.was_open = true;
        events.opened();
        lws_callback_on_writable(caller);
        return 0;
      case LWS_CALLBACK_CLIENT_RECEIVE:
        return receive(in, length);
      case LWS_CALLBACK_CLIENT_WRITEABLE:
        return send();
      case LWS_CALLBACK_WS_PEER_INITIATED_CLOSE:
        peer_closes(in, length);
        return 0;
      case LWS_CALLBACK_CLIENT_CLOSED:
        ended(last);
        return 0;
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        if (open) lws_callback_on_writable(wsi);
        if (stopping) lws_sul_schedule(context, 0, &timer.sul, on_timer, drain_us);
        return 0;
      default:
        return 0;
    }
  }

  static int on_event(lws* wsi, lws_callback_reasons what, void*, void* in, std::size_t length) {
    auto* state = static_cast<State*>(lws_context_user(lws_get_context(wsi)));
    return state && state->context ? state->handle(wsi, what, in, length) : 0;
  }

  struct Timer {  // the C timer first, so that its address is that of the whole
    lws_sorted_usec_list_t sul{};
    State* state = nullptr;
  };
  static void on_timer(lws_sorted_usec_list_t* sul) {
    State* state = reinterpret_cast<Timer*>(sul)->state;
    if (state->stopping)
      state->drained = true;
    else
      state->connect();
  }

  Endpoint endpoint;
  LinkEvents& events;
  // 64 KiB a read: a frame of a few hundred KiB arrives in a handful of callbacks.
  std::array<lws_protocols, 2> protocols{lws_protocols{"cloudscape.v1", on_event, 0, 65536, 0, nullptr, 0},
                                         lws_protocols{}};
  lws_context* context = nullptr;
  lws* wsi = nullptr;
  bool connecting = false, open = false, drained = false;
  Closing last;
  MessageAssembly assembly;
  Timer timer;
  std::atomic<bool> stopping = false;
  std::thread thread;
};

Link::Link(const Endpoint& endpoint, LinkEvents& events) : state_(std::make_unique<State>(endpoint, events)) {}

Link::~Link() {
  state_->stopping = true;
  lws_cancel_service(state_->context);
  state_->thread.join();
  lws_context_destroy(state_->context);
}

void Link::wake() { lws_cancel_service(state_->context); }

}  // namespace cloudscape::viewer
