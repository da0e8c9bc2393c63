// From a whole request to its answer: checks, then the route, then what every answer carries.
#pragma once
#include "net/router.h"
#include "net/site.h"

namespace cloudscape::net {

// What can be said before the body is read: refusals. nullopt: read it, then ask `answer`.
std::optional<Response> refuse_early(const Site& site, const Router& router, const Request& request);
// Never throws.
Answer answer(const Site& site, const Router& router, const Request& request);
// What is added to a response just before it is sent: CORS headers for a listed origin, and the count in /metrics.
Response finished(const Site& site, const Router& router, const Request& request, Response response);

}  // namespace cloudscape::net
