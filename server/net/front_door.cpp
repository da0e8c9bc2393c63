#include "net/front_door.h"

#include "net/metric_names.h"
#include "net/problem.h"
#include "net/request_checks.h"

namespace cloudscape::net {
namespace {

Answer answer_of_route(const Route& route, const Request& request) {
  if (request.method == Method::options) return empty_response(204).with("allow", route.allow());
  const Handler* handler = route.handler(request.method);
  try {
    return (*handler)(request, route.name_in(request.path));
  } catch (const std::exception& error) {
    return problem_of(error);
  }
}

}  // namespace

std::optional<Response> refuse_early(const Site& site, const Router& router, const Request& request) {
  const auto max_body_bytes = static_cast<std::uint64_t>(site.parts.settings.max_body_kib) * 1024;
  if (auto refused = refuse_malformed(request, max_body_bytes)) return refused;
  const Route* route = router.find(request.path);
  if (auto refused = refuse_stranger(request, site, route && route->open)) return refused;
  if (!route) return problem(404, "There is nothing at this path; GET /api/v1/openapi.json lists what there is.");
  if (request.method != Method::options && !route->handler(request.method))
    return problem(405, "This path answers to " + route->allow() + ".").with("allow", route->allow());
  return std::nullopt;
}

Answer answer(const Site& site, const Router& router, const Request& request) {
  if (auto refused = refuse_early(site, router, request)) return *refused;
  return answer_of_route(*router.find(request.path), request);
}

Response finished(const Site& site, const Router& router, const Request& request, Response response) {
  const Route* route = router.find(request.path);
  site.parts.metrics.count(metric::http_requests(route ? route->pattern : "none", response.status));
  response.with("date", http_date(std::time(nullptr)));
  if (!site.authorization.lists_origin(request.origin)) return response;
  response.with("access-control-allow-origin", request.origin).with("vary", "origin");
  response.with("access-control-expose-headers", "etag, retry-after, location, content-range");
  if (request.method == Method::options && route)
    response.with("access-control-allow-methods", route->allow())
        .with("access-control-allow-headers", "authorization, content-type, if-none-match, range, if-range")
        .with("access-control-max-age", "600");
  return response;
}

}  // namespace cloudscape::net
