// The routes of the server, each group in a file of its own name.
#pragma once
#include "net/router.h"
#include "net/site.h"

namespace cloudscape::net {

void add_page_routes(Router& router, const Site& site);
void add_status_routes(Router& router, Site& site);
void add_cloudscape_routes(Router& router, Site& site);
void add_still_routes(Router& router, Site& site);
void add_description_routes(Router& router, const Site& site);  // openapi.json and the document's schema
void add_job_routes(Router& router, Site& site);                // sequences too
Router make_router(Site& site);

bool is_json(const Request& request);  // its body, by its type
// 429 where the client asks for pictures faster than is served.
std::optional<Response> refuse_rate(const Request& request, Site& site);

// An answer that a client may keep but must ask about each time: 304 where its ETag still holds.
Response revalidated(const Request& request, Response response, const std::string& etag);

}  // namespace cloudscape::net
