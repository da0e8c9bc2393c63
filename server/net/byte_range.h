// One range of bytes of a body (RFC 9110, 14): 206, 416, or the whole where the header asks for something else.
#pragma once
#include "net/http_request.h"
#include "net/http_response.h"

namespace cloudscape::net {

// What `whole`, a 200, becomes for this request. A list of ranges and other units are passed over, as they may be; so
// is a range whose If-Range does not name `etag`.
Response ranged(const Request& request, Response whole, const std::string& etag);

}  // namespace cloudscape::net
