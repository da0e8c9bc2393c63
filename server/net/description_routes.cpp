// /api/v1/openapi.json and /api/v1/schema/cloudscape.json: what this server offers, for programs.
#include "net/openapi.h"
#include "net/routes.h"

namespace cloudscape::net {
namespace {

Handler serve_text(const std::string& text, const std::string& type) {
  return [text, type, etag = quoted_etag(text)](const Request& request, auto&) {
    return revalidated(request, text_response(200, type, text), etag);
  };
}

}  // namespace

void add_description_routes(Router& router, const Site& site) {
  router.add({"/api/v1/openapi.json",
              false,
              {{Method::get, serve_text(openapi_document(site.parts.settings), "application/json")}}});
  router.add({"/api/v1/schema/cloudscape.json",
              false,
              {{Method::get, serve_text(settings::cloudscape_schema(), "application/schema+json")}}});
}

}  // namespace cloudscape::net
