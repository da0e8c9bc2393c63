#include "net/routes.h"

namespace cloudscape::net {

Router make_router(Site& site) {
  Router router;
  add_page_routes(router, site);
  add_status_routes(router, site);
  add_cloudscape_routes(router, site);
  add_still_routes(router, site);
  add_description_routes(router, site);
  return router;
}

Response revalidated(const Request& request, Response response, const std::string& etag) {
  if (none_match_holds(request.if_none_match, etag)) response = empty_response(304);
  return response.with("etag", etag).with("cache-control", "no-cache");
}

}  // namespace cloudscape::net
