#include "net/callbacks.h"

#include <algorithm>

#include "core/log.h"
#include "net/handshake.h"
#include "net/lws_request.h"
#include "net/metric_names.h"

namespace cloudscape::net {
namespace {

// Descriptors that stay free for files and the renderer's driver. tuned: a PUT, a cache file and a shader need a few.
constexpr int spare_files = 32;

Connections& connections_of(lws* wsi) { return *static_cast<Connections*>(lws_context_user(lws_get_context(wsi))); }

std::string_view bytes_of(const void* in, std::size_t size) { return {static_cast<const char*>(in), in ? size : 0}; }

void count_open(Connections& all) {
  all.site.parts.metrics.set(metric::connections, static_cast<double>(all.open.size()));
}

// Refuses before libwebsockets runs out of descriptors: it would spin in accept() then, and nobody would be served.
int accept(Connections& all, lws_sockfd_type descriptor) {
  const bool full = all.open.size() >= static_cast<std::size_t>(all.site.parts.settings.max_connections) ||
                    static_cast<int>(descriptor) >= all.open_files_limit - spare_files;
  if (full) all.site.parts.metrics.count(metric::refused("connections"));
  return full ? -1 : 0;
}

HttpConnection& http_of(Connections& all, lws* wsi) {
  return all.http.try_emplace(wsi, all.site, all.router, wsi).first->second;
}

int on_http_event(Connections& all, lws* wsi, lws_callback_reasons reason, void* in, std::size_t size) {
  switch (reason) {
    case LWS_CALLBACK_FILTER_NETWORK_CONNECTION:
      return accept(all, static_cast<lws_sockfd_type>(reinterpret_cast<lws_intptr_t>(in)));
    case LWS_CALLBACK_WSI_CREATE:
      all.open.insert(wsi);
      count_open(all);
      return 0;
    case LWS_CALLBACK_WSI_DESTROY:
      all.http.erase(wsi);
      all.streams.erase(wsi);
      all.open.erase(wsi);
      count_open(all);
      return 0;
    case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
      return http_of(all, wsi).on_upgrade();
    case LWS_CALLBACK_HTTP:
      return http_of(all, wsi).on_request();
    case LWS_CALLBACK_HTTP_BODY:
      return http_of(all, wsi).on_body(bytes_of(in, size));
    case LWS_CALLBACK_HTTP_BODY_COMPLETION:
      return http_of(all, wsi).on_body_complete();
    case LWS_CALLBACK_HTTP_WRITEABLE:
      return http_of(all, wsi).on_writable();
    case LWS_CALLBACK_TIMER:
      return http_of(all, wsi).on_timer();
    case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
      all.on_mail();
      return 0;
    case LWS_CALLBACK_RAW_ADOPT:
    case LWS_CALLBACK_RAW_RX:
      return -1;  // CONNECT makes a raw connection of any request; nothing here speaks raw
    default:
      return 0;
  }
}

int on_stream_event(Connections& all, lws* wsi, lws_callback_reasons reason, void* in, std::size_t size) {
  if (reason == LWS_CALLBACK_ESTABLISHED) {
    all.http.erase(wsi);
    all.streams.try_emplace(wsi, all.site, wsi);
    return 0;
  }
  const auto found = all.streams.find(wsi);
  if (found == all.streams.end()) return 0;
  switch (reason) {
    case LWS_CALLBACK_RECEIVE:
      return found->second.on_receive(bytes_of(in, size));
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return found->second.on_writable();
    case LWS_CALLBACK_TIMER:
      return found->second.on_timer();
    case LWS_CALLBACK_CLOSED:
      all.streams.erase(found);
      return 0;
    default:
      return 0;
  }
}

// An exception must not pass through libwebsockets, which is C: the connection ends instead.
template <auto on_event>
int callback(lws* wsi, lws_callback_reasons reason, void*, void* in, std::size_t size) {
  try {
    return on_event(connections_of(wsi), wsi, reason, in, size);
  } catch (const std::exception& error) {
    log::error("a connection failed: {}", error.what());
    return reason == LWS_CALLBACK_EVENT_WAIT_CANCELLED ? 0 : -1;
  }
}

}  // namespace

bool Connections::busy() const {
  return !streams.empty() || std::ranges::any_of(http, [](const auto& entry) { return entry.second.answering(); });
}

HttpConnection* Connections::waiter(std::uint64_t number) {
  const auto found = std::ranges::find_if(http, [&](const auto& entry) { return entry.second.waiter() == number; });
  return found == http.end() ? nullptr : &found->second;
}

const lws_protocols* protocols() {
  // Per-session data is none of libwebsockets' business: `Connections` owns it.
  static const lws_protocols table[] = {{http_protocol_name.data(), callback<on_http_event>, 0, 4096, 0, nullptr, 0},
                                        {wire::subprotocol.data(), callback<on_stream_event>, 0, 4096, 0, nullptr, 0},
                                        {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
  return table;
}

}  // namespace cloudscape::net
