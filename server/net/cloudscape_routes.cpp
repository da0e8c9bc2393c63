// /api/v1/cloudscapes: the named documents.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "net/header_list.h"
#include "net/problem.h"
#include "net/routes.h"
#include "net/stream_session.h"

namespace cloudscape::net {
namespace {

Response list(const Request& request, const settings::CloudscapeLibrary& library) {
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const auto& entry : library.list())
    entries.push_back(
        {{"name", entry.name}, {"title", entry.title}, {"description", entry.description}, {"preset", entry.preset}});
  const std::string text = nlohmann::ordered_json{{"cloudscapes", entries}}.dump();
  return revalidated(request, json_response(200, text), quoted_etag(text));
}

// The whole document as plain JSON; with ?as=written, the author's text, comments and all.
Response get(const Request& request, const std::string& name, const settings::CloudscapeLibrary& library) {
  const bool as_written = request.query == settings::Parameters{{"as", "written"}};
  if (!request.query.empty() && !as_written)
    throw InvalidInput("/as", "is the only parameter, and must be \"written\"");
  const auto document = library.get(name);
  Response response = as_written ? text_response(200, "text/plain; charset=utf-8", library.text(name))
                                 : json_response(200, settings::to_json(*document));
  const std::string etag = quoted_etag(response.body.bytes);
  return revalidated(request, std::move(response), etag);
}

bool is_preset(const settings::CloudscapeLibrary& library, const std::string& name) {
  return std::ranges::any_of(library.list(), [&](const auto& entry) { return entry.name == name && entry.preset; });
}

Response preset_problem(const std::string& name) {
  return problem(403, "\"" + name + "\" is a preset of the program and cannot be changed: put it under another name.");
}

Response put(const Request& request, const std::string& name, Site& site) {
  const std::string_view type = request.content_type;
  if (!type.empty() && !equal_without_case(trimmed(type.substr(0, type.find(';'))), "application/json"))
    return problem(415, "The body must be application/json.");
  if (is_preset(site.parts.cloudscapes, name)) return preset_problem(name);
  settings::check_bake(settings::parse_cloudscape(request.body, "body"), site.parts.settings.max_bake_mib, "");
  const bool made = site.parts.cloudscapes.put(name, request.body);
  for (StreamSession* session : site.sessions) session->on_document_changed(name);
  return made ? empty_response(201).with("location", "/api/v1/cloudscapes/" + name) : empty_response(204);
}

Response remove(const std::string& name, Site& site) {
  if (is_preset(site.parts.cloudscapes, name)) return preset_problem(name);
  site.parts.cloudscapes.remove(name);
  site.clocks.erase(name);
  return empty_response(204);
}

}  // namespace

void add_cloudscape_routes(Router& router, Site& site) {
  auto& library = site.parts.cloudscapes;
  router.add({"/api/v1/cloudscapes", false, {{Method::get, [&library](const Request& request, auto&) {
                                                return list(request, library);
                                              }}}});
  router.add({"/api/v1/cloudscapes/{name}",
              false,
              {{Method::get, [&](const Request& request, auto& name) { return get(request, name, library); }},
               {Method::put, [&site](const Request& request, auto& name) { return put(request, name, site); }},
               {Method::del, [&site](const Request&, auto& name) { return remove(name, site); }}}});
}

}  // namespace cloudscape::net
