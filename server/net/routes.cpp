#include "net/routes.h"

#include "net/header_list.h"
#include "net/metric_names.h"
#include "net/problem.h"

namespace cloudscape::net {

Router make_router(Site& site) {
  Router router;
  add_page_routes(router, site);
  add_status_routes(router, site);
  add_cloudscape_routes(router, site);
  add_still_routes(router, site);
  add_job_routes(router, site);
  add_description_routes(router, site);
  return router;
}

bool is_json(const Request& request) {
  const std::string_view type = request.content_type;
  return type.empty() || equal_without_case(trimmed(type.substr(0, type.find(';'))), "application/json");
}

std::optional<Response> refuse_rate(const Request& request, Site& site) {
  if (site.still_rate.take(request.client, std::chrono::steady_clock::now())) return std::nullopt;
  site.parts.metrics.count(metric::refused("rate"));
  return busy(429, "This client asks for stills faster than is served: slow down.", 1);
}

Response revalidated(const Request& request, Response response, const std::string& etag) {
  if (none_match_holds(request.if_none_match, etag)) response = empty_response(304);
  return response.with("etag", etag).with("cache-control", "no-cache");
}

}  // namespace cloudscape::net
