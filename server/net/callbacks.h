// The callbacks of libwebsockets, as plain functions on the connections that they belong to.
#pragma once
#include <libwebsockets.h>

#include <map>
#include <set>

#include "net/http_connection.h"
#include "net/routes.h"
#include "net/stream_socket.h"

namespace cloudscape::net {

// Everything that lives on the network thread.
struct Connections {
  explicit Connections(Site& given) : site(given), router(make_router(given)) {}

  Site& site;
  const Router router;
  int open_files_limit = 1024;
  std::set<lws*> open;  // accepted and not yet destroyed
  std::map<lws*, HttpConnection> http;
  std::map<lws*, StreamSocket> streams;
  std::function<void()> on_mail;

  bool busy() const;  // something is being answered, or a viewer is still here
  HttpConnection* waiter(std::uint64_t number);
};

// Both protocols, the sentinel included; the context's user pointer is a Connections.
const lws_protocols* protocols();

}  // namespace cloudscape::net
