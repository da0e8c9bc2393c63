// Pieces that the OpenAPI document is put together from.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cloudscape::net::openapi {

using Json = nlohmann::ordered_json;

inline Json reference(const std::string& name) { return {{"$ref", "#/components/schemas/" + name}}; }

inline Json content(const std::string& type, const Json& schema) { return {{type, {{"schema", schema}}}}; }

inline Json answer(const std::string& description, const Json& content = nullptr) {
  Json json{{"description", description}};
  if (!content.is_null()) json["content"] = content;
  return json;
}

// Adds the refusals to an operation's `answers`: {"404", "No such cloudscape."}, ...
inline Json with_problems(Json answers, const std::vector<std::pair<std::string, std::string>>& problems) {
  for (const auto& [status, description] : problems)
    answers[status] = answer(description, content("application/problem+json", reference("Problem")));
  return answers;
}

inline Json operation(const std::string& id, const std::string& summary, const Json& answers) {
  return {{"operationId", id}, {"summary", summary}, {"responses", answers}};
}

inline const std::vector<std::pair<std::string, std::string>> body_problems{
    {"411", "No Content-Length."}, {"413", "The body is too large."}, {"415", "The body is not JSON."}};

// A body's schema with the member "cloudscape".
inline Json with_cloudscape(Json schema, const Json& required) {
  schema["properties"]["cloudscape"] = {{"description", "Name, or a whole document."},
                                        {"oneOf", {Json{{"type", "string"}}, reference("Cloudscape")}}};
  schema["required"] = required;
  return schema;
}

// openapi_jobs.cpp
Json sequences();
Json references();
Json job();
Json job_result();
Json sequence_body();
Json job_schema();

}  // namespace cloudscape::net::openapi
