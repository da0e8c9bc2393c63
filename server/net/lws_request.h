// Copies a request out of libwebsockets' header table, which lives only as long as the callback.
#pragma once
#include "net/http_request.h"

struct lws;

namespace cloudscape::net {

Request copy_request(lws* wsi);
std::string peer_address(lws* wsi);

}  // namespace cloudscape::net
