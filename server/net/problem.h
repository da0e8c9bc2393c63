// Errors over HTTP: application/problem+json (RFC 9457), one sentence in `detail`, and `pointer` to the wrong value.
#pragma once
#include <exception>
#include <string>

#include "net/http_response.h"

namespace cloudscape::net {

Response problem(int status, const std::string& detail, const std::string& pointer = "");
// 503 or 429 with Retry-After.
Response busy(int status, const std::string& detail, int retry_after_s);
// InvalidInput 400, NotFound 404, OverLimit 422, anything else 500 without its inner details.
Response problem_of(const std::exception& error);

}  // namespace cloudscape::net
