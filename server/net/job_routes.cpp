// /api/v1/sequences, /api/v1/references and /api/v1/jobs: work that is ordered, looked after, fetched and deleted.
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "net/byte_range.h"
#include "net/header_list.h"
#include "net/mapped_file.h"
#include "net/problem.h"
#include "net/routes.h"
#include "net/single_file.h"
#include "settings/sequence_request.h"

namespace cloudscape::net {
namespace {

std::string link_of(const Job& job) { return "/api/v1/jobs/" + job.id; }

// "2026-11-21T12:00:00Z" (RFC 3339).
std::string date_text(JobTime time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[40] = "";
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string job_json(const Job& job, const Jobs& jobs) {
  nlohmann::ordered_json json{{"id", job.id},
                              {"kind", job.plan.kind},
                              {"state", name_of(job.state)},
                              {"frames_done", job.written},
                              {"frames", job.plan.frames},
                              {"samples_done", job.samples},
                              {"samples", job.plan.samples},
                              {"progress", job.progress()},
                              {"created", date_text(job.created)},
                              {"bytes", job.bytes},
                              {"result", nullptr},
                              {"error", nullptr},
                              {"ended", nullptr},
                              {"expires", nullptr}};
  if (job.state == JobState::done) json["result"] = link_of(job) + "/result";
  if (!job.error.empty()) json["error"] = job.error;
  if (!job.active()) json["ended"] = date_text(job.ended), json["expires"] = date_text(jobs.expires(job));
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Response job_answer(int status, const Job& job, const Jobs& jobs) {
  return json_response(status, job_json(job, jobs)).with("cache-control", "no-store");
}

Response no_such_job() { return problem(404, "There is no such job: it was deleted, has expired, or never was."); }

JobPlan plan_of(settings::SequenceRequest request, const JobParts& parts) {
  const bool avi = request.container == ContainerKind::avi;
  const ContainerLayout layout{request.container,           request.still.encoding.format,
                               request.still.frame.size_px, request.range.frames_per_second,
                               request.range.first,         request.frames()};
  JobPlan plan;
  plan.kind = "sequence";
  plan.frames = request.frames();
  plan.samples = request.still.frame.quality.samples;
  plan.encoding = request.still.encoding;
  plan.open_result = [open = parts.open_container, layout](const auto& file) { return open(file, layout); };
  plan.media_type = avi ? "video/x-msvideo" : "application/zip";
  plan.file_name = avi ? "sequence.avi" : "sequence.zip";
  plan.frame = [shared = std::make_shared<const settings::SequenceRequest>(std::move(request))](int index) {
    return shared->frame(shared->range.first + index);
  };
  return plan;
}

// One picture, traced: the result is its file.
JobPlan plan_of(settings::StillRequest request) {
  JobPlan plan;
  plan.kind = "reference";
  plan.samples = request.frame.quality.samples;
  plan.encoding = request.encoding;
  plan.open_result = open_single_file;
  plan.media_type = media_type(request.encoding.format);
  const std::string_view format = name_of(request.encoding.format);
  plan.file_name = "reference." + std::string(format == "jpeg" ? "jpg" : format);
  plan.frame = [frame = std::move(request.frame)](int) { return frame; };
  return plan;
}

Answer order(const Request& request, Site& site, JobPlan plan) {
  const auto ordered = site.jobs.order(request.client, std::move(plan));
  if (const auto* refused = std::get_if<Response>(&ordered)) return *refused;
  const Job& job = *std::get<const Job*>(ordered);
  return job_answer(202, job, site.jobs).with("location", link_of(job));
}

Answer post_reference(const Request& request, Site& site) {
  if (!is_json(request)) return problem(415, "The body must be application/json.");
  if (auto refused = refuse_unready(site)) return *refused;
  if (auto refused = refuse_rate(request, site)) return *refused;
  auto limits = settings::still_limits(site.parts.settings);
  limits.max_gigasteps = site.parts.settings.max_job_gigasteps;
  auto still = settings::still_from_json(request.body, site.parts.cloudscapes, limits);
  if (still.frame.quality.technique != Technique::path_tracing)
    throw InvalidInput("/image/quality", "must be reference: other qualities are rendered by POST /api/v1/stills");
  return order(request, site, plan_of(std::move(still)));
}

Answer post_sequence(const Request& request, Site& site) {
  if (!is_json(request)) return problem(415, "The body must be application/json.");
  if (auto refused = refuse_unready(site)) return *refused;
  if (auto refused = refuse_rate(request, site)) return *refused;
  auto sequence = settings::sequence_from_json(request.body, site.parts.cloudscapes,
                                               settings::sequence_limits(site.parts.settings));
  return order(request, site, plan_of(std::move(sequence), site.parts.jobs));
}

Answer get_job(const std::string& id, Site& site) {
  site.jobs.forget_expired();
  const Job* job = site.jobs.find(id);
  return job ? job_answer(200, *job, site.jobs) : no_such_job();
}

Answer delete_job(const std::string& id, Site& site) {
  return site.jobs.remove(id) ? empty_response(204) : no_such_job();
}

std::string why_no_result(const Job& job) {
  if (job.active())
    return "The job is at frame " + std::to_string(job.written) + " of " + std::to_string(job.plan.frames) +
           ": ask again when its state is done.";
  return "The job " + std::string(job.state == JobState::failed ? "failed" : "was cancelled") + ": " + job.error;
}

Answer get_result(const Request& request, const std::string& id, Site& site) {
  site.jobs.forget_expired();
  const Job* job = site.jobs.find(id);
  if (!job) return no_such_job();
  if (job->state != JobState::done) return problem(409, why_no_result(*job));
  const std::string etag = quoted_etag("result of " + job->id);  // which never changes
  const auto marked = [&](Response response) {
    return response.with("etag", etag).with("cache-control", "private, no-cache");
  };
  if (none_match_holds(request.if_none_match, etag)) return marked(empty_response(304));
  Response whole{200, job->plan.media_type, {}, mapped_body(job->file), false};
  whole.with("content-disposition", "attachment; filename=\"" + job->plan.file_name + "\"");
  return marked(ranged(request, std::move(whole), etag));
}

}  // namespace

void add_job_routes(Router& router, Site& site) {
  router.add({"/api/v1/sequences", false, {{Method::post, [&site](const Request& request, auto&) {
                                              return post_sequence(request, site);
                                            }}}});
  router.add({"/api/v1/references", false, {{Method::post, [&site](const Request& request, auto&) {
                                               return post_reference(request, site);
                                             }}}});
  router.add({"/api/v1/jobs/{id}",
              false,
              {{Method::get, [&site](auto&, const std::string& id) { return get_job(id, site); }},
               {Method::del, [&site](auto&, const std::string& id) { return delete_job(id, site); }}}});
  router.add({"/api/v1/jobs/{id}/result", false, {{Method::get, [&site](const Request& request, const std::string& id) {
                                                     return get_result(request, id, site);
                                                   }}}});
}

}  // namespace cloudscape::net
