// Sequences and jobs in the OpenAPI document.
#include "net/openapi_parts.h"
#include "settings/described_schema.h"
#include "settings/sequence_request.h"
#include "settings/still_body.h"

namespace cloudscape::net::openapi {
namespace {

Json id_parameter() {
  return {{"name", "id"},
          {"in", "path"},
          {"required", true},
          {"schema", {{"type", "string"}, {"pattern", "^[0-9a-f]{32}$"}}}};
}

const std::vector<std::pair<std::string, std::string>> unknown_job{
    {"400", "The request is malformed."},
    {"401", "The token is missing or wrong."},
    {"404", "There is no such job: it was deleted, has expired, or never was."}};

const std::vector<std::pair<std::string, std::string>> job_problems{
    {"400", "A wrong value; `pointer` says which."},
    {"401", "The token is missing or wrong."},
    {"403", "The page is another site's."},
    {"404", "No such cloudscape or path."},
    {"422", "Above a limit of this server; `detail` names it."},
    {"429", "This client has too many jobs; Retry-After says when again."},
    {"503", "Starting, stopping, or no room for another job; see Retry-After."}};

// The lens without what the path gives.
Json lens_schema() {
  Json lens = settings::detail::schema_of(Lens{});
  lens["properties"].erase("vertical_fov_deg");
  return lens;
}

Json text() { return {{"type", "string"}}; }
Json text_or_null() { return {{"type", {"string", "null"}}}; }

}  // namespace

Json sequence_body() {
  Json schema = settings::detail::schema_of(settings::StillBody{});
  Json& properties = schema["properties"];
  properties["camera"] = {{"type", "object"},
                          {"description", "The lens; the path gives the rest."},
                          {"properties", {{"lens", lens_schema()}}},
                          {"additionalProperties", false}};
  properties["path"] = {{"description", "Name of a camera path, or a path: poses and fields of view in time."},
                        {"oneOf", {text(), settings::detail::schema_of(settings::CameraPath{})}}};
  properties["frames"] = settings::detail::schema_of(settings::FrameRange{});
  properties["container"] = {{"type", "string"},
                             {"enum", {"zip", "avi"}},
                             {"default", "zip"},
                             {"description", "zip: a file a frame. avi: Motion JPEG, for the format jpeg."}};
  return with_cloudscape(std::move(schema), {"cloudscape", "path"});
}

Json job_schema() {
  const Json count{{"type", "integer"}, {"minimum", 0}};
  Json properties{{"id", text()},
                  {"kind", {{"type", "string"}, {"enum", {"sequence", "reference"}}}},
                  {"state", {{"type", "string"}, {"enum", {"queued", "rendering", "done", "failed", "cancelled"}}}},
                  {"frames_done", count},
                  {"frames", count},
                  {"samples_done", count},
                  {"samples", count},
                  {"progress", {{"type", "number"}, {"minimum", 0}, {"maximum", 1}}},
                  {"created", text()},
                  {"bytes", {{"type", "integer"}, {"description", "Of the result, so far."}}},
                  {"result", {{"type", {"string", "null"}}, {"description", "Where it is, when the job is done."}}},
                  {"error", text_or_null()},
                  {"ended", text_or_null()},
                  {"expires", text_or_null()}};
  Json required = Json::array();
  for (const auto& [name, schema] : properties.items()) required.push_back(name);
  return {{"type", "object"}, {"required", required}, {"properties", properties}};
}

Json sequences() {
  Json post = operation("postSequence",
                        "Orders frames along a camera path; they are rendered while nobody else wants the renderer.",
                        with_problems(with_problems({{"202", answer("The job; Location says where to ask for it.",
                                                                    content("application/json", reference("Job")))}},
                                                    body_problems),
                                      job_problems));
  post["requestBody"] = {{"required", true}, {"content", content("application/json", reference("SequenceRequest"))}};
  return {{"post", post}};
}

Json references() {
  Json post = operation(
      "postReference", "Orders a still of the quality reference, which is traced while nobody else wants the renderer.",
      with_problems(
          with_problems({{"202", answer("The job; Location says where to ask for it. Its result is the picture.",
                                        content("application/json", reference("Job")))}},
                        body_problems),
          job_problems));
  post["requestBody"] = {{"required", true}, {"content", content("application/json", reference("StillRequest"))}};
  return {{"post", post}};
}

Json job() {
  Json get = operation(
      "getJob", "How far a job is.",
      with_problems({{"200", answer("The job.", content("application/json", reference("Job")))}}, unknown_job));
  Json remove = operation("deleteJob", "Cancels a job, or deletes it and its result.",
                          with_problems(with_problems({{"204", answer("It is gone.")}}, unknown_job),
                                        {{"403", "The page is another site's."}}));
  return {{"parameters", {id_parameter()}}, {"get", get}, {"delete", remove}};
}

Json job_result() {
  const Json binary{{"type", "string"}, {"contentEncoding", "binary"}};
  const Json files{{"application/zip", {{"schema", binary}}},
                   {"video/x-msvideo", {{"schema", binary}}},
                   {"image/jpeg", {{"schema", binary}}},
                   {"image/png", {{"schema", binary}}},
                   {"image/x-exr", {{"schema", binary}}}};
  Json get = operation("getJobResult", "The file that a job has made. One range of bytes may be asked for.",
                       with_problems(with_problems({{"200", answer("The file, with a strong ETag.", files)},
                                                    {"206", answer("The part that Range names.", files)},
                                                    {"304", answer("If-None-Match names it.")}},
                                                   unknown_job),
                                     {{"409", "The job is not done, or has failed; `detail` says which."},
                                      {"416", "The range lies outside of the file."}}));
  return {{"parameters", {id_parameter()}}, {"get", get}};
}

}  // namespace cloudscape::net::openapi
