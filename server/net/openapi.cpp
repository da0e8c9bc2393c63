#include "net/openapi.h"

#include "core/version.h"
#include "net/openapi_parts.h"
#include "settings/cloudscape_json.h"
#include "settings/described_schema.h"
#include "settings/still_body.h"
#include "settings/still_request.h"

namespace cloudscape::net {
namespace {

using namespace openapi;

Json open(Json operation) {
  operation["security"] = Json::array();
  return operation;
}

// A number or boolean from the query is text there; its own JSON type says what the text must be.
Json default_of(const settings::ParameterInfo& info) {
  if (info.type == "string") return info.default_text;
  return Json::parse(info.default_text, nullptr, false);
}

Json parameter(const settings::ParameterInfo& info) {
  Json schema{{"type", info.type}};
  if (!info.values.empty()) schema["enum"] = info.values;
  if (info.min) schema["minimum"] = *info.min;
  if (info.max) schema["maximum"] = *info.max;
  std::string description = info.description;
  const Json value = default_of(info);
  if (!value.is_discarded() && info.default_text != "")
    schema["default"] = value;
  else if (!info.default_text.empty())
    description += " Default: " + info.default_text + ".";
  return {{"name", info.name}, {"in", "query"}, {"required", false}, {"description", description}, {"schema", schema}};
}

Json still_parameters(const settings::ServerSettings& settings) {
  Json parameters = Json::array();
  for (const auto& info : settings::still_parameters(settings::still_limits(settings)))
    parameters.push_back(parameter(info));
  return parameters;
}

Json still_answers() {
  const Json binary{{"type", "string"}, {"contentEncoding", "binary"}};
  const Json pictures{
      {"image/jpeg", {{"schema", binary}}}, {"image/png", {{"schema", binary}}}, {"image/x-exr", {{"schema", binary}}}};
  Json answers{{"200", answer("The picture, with a strong ETag.", pictures)},
               {"304", answer("If-None-Match names the picture that this would be; nothing was rendered.")}};
  return with_problems(
      std::move(answers),
      {{"400", "A wrong value; `pointer` says which."},
       {"401", "The token is missing or wrong."},
       {"404", "No such cloudscape or still."},
       {"422", "Above a limit of this server, or a file that the document names cannot be used; `detail` says which."},
       {"429", "This client asks for too much; Retry-After says when again."},
       {"500", "The renderer failed."},
       {"503", "Starting, stopping, queue full or too slow; see Retry-After."}});
}

Json still_body() {
  Json schema = settings::detail::schema_of(settings::StillBody{});
  const Json heading = settings::detail::schema_of(settings::StillHeading{});
  for (const auto& [name, member] : heading["properties"].items()) schema["properties"][name] = member;
  return with_cloudscape(schema, {"cloudscape"});
}

Json named_stills() {
  const std::vector<std::string> members{"name", "title", "description", "view"};
  Json entry{{"type", "object"}, {"required", members}};
  for (const std::string& name : members) entry["properties"][name] = {{"type", "string"}};
  entry["properties"]["view"]["description"] =
      "Parameters that show the same place in the same light, of getStill and of a link to the page; empty if that is "
      "more than a stream can show.";
  const Json list{{"type", "object"},
                  {"required", {"stills"}},
                  {"properties", {{"stills", {{"type", "array"}, {"items", entry}}}}}};
  return {
      {"get", operation("listStills", "The stills that have names, for getStill's parameter `still`.",
                        with_problems({{"200", answer("Their names and titles.", content("application/json", list))},
                                       {"304", answer("Not changed.")}},
                                      {{"401", "The token is missing or wrong."}}))}};
}

Json stills(const settings::ServerSettings& settings) {
  Json get = operation("getStill", "One picture, by query.", still_answers());
  get["parameters"] = still_parameters(settings);
  Json head = operation("headStill", "The headers of the picture; it is rendered for them.", still_answers());
  head["parameters"] = get["parameters"];
  Json post = operation("postStill", "One picture, by a JSON body that may hold a whole document.",
                        with_problems(still_answers(), body_problems));
  post["requestBody"] = {{"required", true}, {"content", content("application/json", reference("StillRequest"))}};
  return {{"get", get}, {"head", head}, {"post", post}};
}

Json name_parameter() {
  return {{"name", "name"},
          {"in", "path"},
          {"required", true},
          {"schema", {{"type", "string"}, {"pattern", "^[a-z][a-z0-9-]{0,63}$"}}}};
}

Json cloudscapes() {
  const Json entry{{"type", "object"},
                   {"required", {"name", "title", "description", "preset"}},
                   {"properties",
                    {{"name", {{"type", "string"}}},
                     {"title", {{"type", "string"}}},
                     {"description", {{"type", "string"}}},
                     {"preset", {{"type", "boolean"}}}}}};
  const Json list{{"type", "object"},
                  {"required", {"cloudscapes"}},
                  {"properties", {{"cloudscapes", {{"type", "array"}, {"items", entry}}}}}};
  return {
      {"get", operation("listCloudscapes", "The named documents.",
                        with_problems({{"200", answer("Their names and titles.", content("application/json", list))},
                                       {"304", answer("Not changed.")}},
                                      {{"401", "The token is missing or wrong."}}))}};
}

Json cloudscape() {
  const std::vector<std::pair<std::string, std::string>> unknown{{"400", "A parameter or name is wrong."},
                                                                 {"401", "The token is missing or wrong."},
                                                                 {"404", "No such cloudscape."}};
  Json documents = content("application/json", reference("Cloudscape"));
  documents["text/plain"] = {{"schema", {{"type", "string"}}}};
  Json get =
      operation("getCloudscape", "The whole document, every field.",
                with_problems({{"200", answer("The document.", documents)}, {"304", answer("Not changed.")}}, unknown));
  get["parameters"] = {{{"name", "as"},
                        {"in", "query"},
                        {"description", "written: the author's text, comments and all."},
                        {"schema", {{"type", "string"}, {"enum", {"written"}}}}}};
  Json put = operation(
      "putCloudscape", "Stores a document; viewers of it see the change at once.",
      with_problems(with_problems({{"201", answer("It is new.")}, {"204", answer("It was replaced.")}}, body_problems),
                    {{"400", "A wrong value; `pointer` says which."},
                     {"401", "The token is missing or wrong."},
                     {"403", "The name is a preset's, or the page is another site's."},
                     {"422", "There are too many documents."}}));
  put["requestBody"] = {{"required", true}, {"content", content("application/json", reference("Cloudscape"))}};
  Json remove = operation("deleteCloudscape", "Forgets a document.",
                          with_problems(with_problems({{"204", answer("It is gone.")}}, unknown),
                                        {{"403", "It is a preset, or the page is another site's."}}));
  return {{"parameters", {name_parameter()}}, {"get", get}, {"put", put}, {"delete", remove}};
}

Json text_operation(const std::string& id, const std::string& summary, const std::string& type) {
  return operation(id, summary, {{"200", answer(summary, content(type, Json::object()))}});
}

Json paths(const settings::ServerSettings& settings) {
  Json ready =
      open(text_operation("ready", "Whether pictures can be asked for, and what renders them.", "application/json"));
  ready["responses"]["200"]["content"]["application/json"]["schema"] = reference("Readiness");
  ready["responses"]["503"] = answer("Starting or stopping.", content("application/json", reference("Readiness")));
  return {{"/healthz", {{"get", open(text_operation("health", "The server lives.", "application/json"))}}},
          {"/readyz", {{"get", ready}}},
          {"/metrics", {{"get", text_operation("metrics", "Prometheus metrics.", "text/plain")}}},
          {"/api/v1/openapi.json", {{"get", text_operation("openapi", "This document.", "application/json")}}},
          {"/api/v1/schema/cloudscape.json",
           {{"get", text_operation("schema", "JSON Schema of a cloudscape.", "application/schema+json")}}},
          {"/api/v1/cloudscapes", cloudscapes()},
          {"/api/v1/cloudscapes/{name}", cloudscape()},
          {"/api/v1/stills", stills(settings)},
          {"/api/v1/stills/named", named_stills()},
          {"/api/v1/sequences", sequences()},
          {"/api/v1/references", references()},
          {"/api/v1/jobs/{id}", job()},
          {"/api/v1/jobs/{id}/result", job_result()}};
}

Json problem_schema() {
  return {{"type", "object"},
          {"description", "RFC 9457."},
          {"required", {"type", "title", "status", "detail"}},
          {"properties",
           {{"type", {{"type", "string"}}},
            {"title", {{"type", "string"}}},
            {"status", {{"type", "integer"}}},
            {"detail", {{"type", "string"}, {"description", "One sentence: what is wrong, and the remedy."}}},
            {"pointer", {{"type", "string"}, {"description", "JSON pointer to the wrong value (RFC 6901)."}}}}}};
}

Json readiness_schema() {
  Json properties{{"ready", {{"type", "boolean"}}}, {"software", {{"type", "boolean"}}}};
  for (const char* name : {"reason", "version", "renderer", "vendor", "gl_version", "pass_execution"})
    properties[name] = {{"type", "string"}};
  Json required = Json::array();
  for (const auto& [name, schema] : properties.items()) required.push_back(name);
  return {{"type", "object"}, {"required", required}, {"properties", properties}};
}

}  // namespace

std::string openapi_document(const settings::ServerSettings& settings) {
  const Json document{{"openapi", "3.1.0"},
                      {"info",
                       {{"title", "cloudscape"},
                        {"version", version},
                        {"description",
                         "Pictures of clouds. Live views are streamed over a WebSocket at /api/v1/stream, subprotocol "
                         "cloudscape.v1."}}},
                      {"security", {Json{{"token", Json::array()}}}},
                      {"paths", paths(settings)},
                      {"components",
                       {{"securitySchemes", {{"token", {{"type", "http"}, {"scheme", "bearer"}}}}},
                        {"schemas",
                         {{"Problem", problem_schema()},
                          {"Readiness", readiness_schema()},
                          {"StillRequest", still_body()},
                          {"SequenceRequest", sequence_body()},
                          {"Job", job_schema()},
                          {"Cloudscape", Json::parse(settings::cloudscape_schema())}}}}}};
  return document.dump(2);
}

}  // namespace cloudscape::net
