// /api/v1/stills: one picture, by query or by JSON body.
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/version.h"
#include "net/header_list.h"
#include "net/problem.h"
#include "net/routes.h"
#include "settings/named_files.h"

namespace cloudscape::net {
namespace {

// The same picture has the same ETag on every server with this program and this renderer.
std::string etag_of(const settings::StillRequest& still, const Site& site) {
  const std::string files = settings::stamps_of_named_files(*still.frame.cloudscape, site.parts.settings);
  return quoted_etag(still.canonical + '\n' + files + '\n' + version + '\n' + site.renderer->renderer);
}

// What takes longer than a client waits for an answer is refused before it is begun.
void check_traced(const FrameRequest& frame) {
  if (frame.quality.technique != Technique::path_tracing) return;
  // tuned: half a minute and a minute of two cores.
  constexpr double most_budget_s = 30, most_gigasteps = 1;
  const double gigasteps =
      1e-9 * frame.size_px.width * frame.size_px.height * frame.quality.samples * frame.quality.max_steps;
  if (frame.tracing.time_budget_s.value_or(1e9) <= most_budget_s || gigasteps <= most_gigasteps) return;
  throw OverLimit("/quality",
                  "is reference, and so much of it takes longer than this answer may: POST the still "
                  "to /api/v1/references, which answers with a job, or ask for fewer samples or pixels, or for "
                  "a time_budget_s of 30 or less");
}

Answer order(const Request& request, Site& site, const settings::StillRequest& still) {
  const std::string etag = etag_of(still, site);
  if (none_match_holds(request.if_none_match, etag))
    return empty_response(304).with("etag", etag).with("cache-control", "private, no-cache");
  check_traced(still.frame);
  return site.stills.order(request.client, still, etag);
}

Answer get_still(const Request& request, Site& site) {
  if (auto refused = refuse_unready(site)) return *refused;
  if (auto refused = refuse_rate(request, site)) return *refused;
  const auto limits = settings::still_limits(site.parts.settings);
  return order(request, site, settings::still_from_parameters(request.query, site.parts.cloudscapes, limits));
}

Answer post_still(const Request& request, Site& site) {
  if (!is_json(request)) return problem(415, "The body must be application/json.");
  if (auto refused = refuse_unready(site)) return *refused;
  if (auto refused = refuse_rate(request, site)) return *refused;
  const auto limits = settings::still_limits(site.parts.settings);
  return order(request, site, settings::still_from_json(request.body, site.parts.cloudscapes, limits));
}

Response list(const Request& request) {
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const auto& entry : settings::named_stills())
    entries.push_back(
        {{"name", entry.name}, {"title", entry.title}, {"description", entry.description}, {"view", entry.view}});
  const std::string text = nlohmann::ordered_json{{"stills", entries}}.dump();
  return revalidated(request, json_response(200, text), quoted_etag(text));
}

}  // namespace

void add_still_routes(Router& router, Site& site) {
  router.add(
      {"/api/v1/stills/named", false, {{Method::get, [](const Request& request, auto&) { return list(request); }}}});
  router.add({"/api/v1/stills",
              false,
              {{Method::get, [&site](const Request& request, auto&) { return get_still(request, site); }},
               {Method::post, [&site](const Request& request, auto&) { return post_still(request, site); }}}});
}

}  // namespace cloudscape::net
