// /healthz: the network thread lives. /readyz: pictures can be asked for, and from what. /metrics: Prometheus text.
#include <nlohmann/json.hpp>

#include "core/version.h"
#include "net/routes.h"

namespace cloudscape::net {
namespace {

Response health() { return json_response(200, R"({"status":"ok"})").with("cache-control", "no-store"); }

Response readiness(const Site& site) {
  nlohmann::ordered_json body{{"ready", site.ready()},
                              {"reason", site.draining   ? "stopping"
                                         : site.renderer ? ""
                                                         : "starting"},
                              {"version", version}};
  const RendererInfo info = site.renderer.value_or(RendererInfo{});
  body.update({{"renderer", info.renderer},
               {"vendor", info.vendor},
               {"gl_version", info.gl_version},
               {"software", info.software},
               {"pass_execution", info.pass_execution}});
  // The driver's names need not be UTF-8.
  Response response =
      json_response(site.ready() ? 200 : 503, body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  if (!site.ready()) response.with("retry-after", "1");
  return response.with("cache-control", "no-store");
}

}  // namespace

void add_status_routes(Router& router, Site& site) {
  router.add({"/healthz", true, {{Method::get, [](auto&...) { return health(); }}}});
  router.add({"/readyz", true, {{Method::get, [&site](auto&...) { return readiness(site); }}}});
  router.add({"/metrics", false, {{Method::get, [&site](auto&...) {
                                     return text_response(200, "text/plain; version=0.0.4; charset=utf-8",
                                                          site.parts.metrics.prometheus_text())
                                         .with("cache-control", "no-store");
                                   }}}});
}

}  // namespace cloudscape::net
