#include "net/jobs.h"

#include <algorithm>

#include "core/log.h"
#include "net/authorization.h"
#include "net/metric_names.h"
#include "net/problem.h"

namespace cloudscape::net {
namespace {

// tuned: a short job need not wait for the long one before it, and neither is slowed by more than one other.
constexpr int rendering_at_once = 2;
// tuned: the next frame is rendered while one is encoded and one written.
constexpr int frames_ahead = 3;
constexpr std::size_t max_ended = 256;  // tuned: what is told of each is small; their files are bounded by bytes
constexpr int retry_after_s = 30;       // tuned: jobs take minutes

std::optional<JobFolder> make_folder(const settings::ServerSettings& settings, bool wanted) {
  if (!wanted) return std::nullopt;
  try {
    return std::optional<JobFolder>(std::in_place, settings.jobs_dir);
  } catch (const Error& error) {
    if (!settings.jobs_dir.empty()) throw;
    log::warn("no jobs are taken: {}", error.what());
    return std::nullopt;
  }
}

JobTime::duration seconds(double s) {
  return std::chrono::duration_cast<JobTime::duration>(std::chrono::duration<double>(s));
}

}  // namespace

// The first failure ends it.
struct Job::Result {
  std::unique_ptr<FrameContainer> container;
  bool failed = false;

  void attempt(const std::string& id, const Jobs::Post& post, auto&& write) {
    if (failed) return;
    try {
      post({id, "", write()});
    } catch (const std::exception& error) {
      failed = true;
      container.reset();
      post({id, error.what(), 0});
    }
  }
};

std::string_view name_of(JobState state) {
  constexpr std::string_view names[] = {"queued", "rendering", "done", "failed", "cancelled"};
  return names[static_cast<std::size_t>(state)];
}

Jobs::Jobs(const Parts& parts, Clock clock)
    : scheduler_(parts.scheduler),
      metrics_(parts.metrics),
      max_jobs_(static_cast<std::size_t>(parts.settings.max_jobs)),
      max_bytes_(static_cast<std::uint64_t>(parts.settings.job_results_mib * 1024 * 1024)),
      kept_(seconds(parts.settings.job_kept_s)),
      clock_(std::move(clock)),
      folder_(make_folder(parts.settings, static_cast<bool>(parts.jobs.run_on_disk_thread))) {
  if (folder_) disk_.emplace(parts.jobs.run_on_disk_thread);
  publish();
}

std::optional<Response> Jobs::refusal(const std::string& client) const {
  if (!folder_) return problem(503, "This server has no folder for the results of jobs; its log says why.");
  const auto active = std::ranges::count_if(jobs_, &Job::active);
  const auto of_client =
      std::ranges::count_if(jobs_, [&](const Job& job) { return job.active() && job.client == client; });
  // One client leaves room for another's job.
  const auto max_of_client = static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, max_jobs_ / 2));
  if (of_client >= max_of_client)
    return busy(429,
                "This client has " + std::to_string(of_client) +
                    " jobs at work already: wait for one, or delete it; one client may have half of max_jobs.",
                retry_after_s);
  if (active >= static_cast<std::ptrdiff_t>(max_jobs_))
    return busy(503, "There are as many jobs as this server takes (max_jobs): ask again later.", retry_after_s);
  if (bytes() >= max_bytes_)
    return busy(503, "The results of jobs fill their room (job_results_mib): ask again when some have expired.",
                retry_after_s);
  return std::nullopt;
}

std::variant<const Job*, Response> Jobs::order(const std::string& client, JobPlan plan) {
  forget_expired();
  if (auto refused = refusal(client)) {
    metrics_.count(metric::refused("jobs"));
    return *refused;
  }
  Job& job = jobs_.emplace_back();
  job.id = random_hex();
  job.client = client;
  job.plan = std::move(plan);
  job.created = clock_();
  job.file = folder_->path() / std::to_string(++last_file_);  // not the id, which opens the result
  job.result = std::make_shared<Job::Result>();
  go_on();
  return &job;
}

const Job* Jobs::find(std::string_view id) const {
  const auto found = std::ranges::find_if(jobs_, [&](const Job& job) { return equal_in_constant_time(job.id, id); });
  return found == jobs_.end() ? nullptr : &*found;
}

Job* Jobs::find_active(std::string_view id) {
  auto* job = const_cast<Job*>(find(id));
  return job && job->active() ? job : nullptr;
}

Job* Jobs::find_by_still(StreamId still) {
  const auto found = std::ranges::find_if(jobs_, [&](const Job& job) { return job.rendering.contains(still); });
  return found == jobs_.end() ? nullptr : &*found;
}

bool Jobs::owns(StreamId still) const {
  return std::ranges::any_of(jobs_, [&](const Job& job) { return job.rendering.contains(still); });
}

bool Jobs::remove(std::string_view id) {
  const auto found = std::ranges::find_if(jobs_, [&](const Job& job) { return equal_in_constant_time(job.id, id); });
  if (found == jobs_.end()) return false;
  if (found->active()) end(*found, JobState::cancelled);
  drop_file(*found);
  jobs_.erase(found);
  go_on();
  return true;
}

// Begins what may begin, and keeps the scheduler supplied.
void Jobs::go_on() {
  auto rendering = std::ranges::count(jobs_, JobState::rendering, &Job::state);
  for (Job& job : jobs_) {
    if (job.state == JobState::queued && rendering < rendering_at_once) {
      job.state = JobState::rendering;
      ++rendering;
    }
    if (job.state == JobState::rendering) submit(job);
  }
  publish();
}

void Jobs::submit(Job& job) {
  while (job.submitted < job.plan.frames && job.submitted - job.written < frames_ahead) {
    const auto still = scheduler_.submit_background(job.plan.frame(job.submitted), job.plan.encoding);
    if (!still) return;  // it stops
    job.rendering[*still] = job.submitted++;
  }
}

void Jobs::note_samples(StreamId still, double share, int samples) {
  Job* job = find_by_still(still);
  // Of frames that are rendered side by side, the first.
  if (!job || job->rendering.at(still) != job->given) return;
  job->share = share, job->samples = samples;
}

void Jobs::deliver(StreamId still, EncodedFrame image) {
  Job* job = find_by_still(still);
  if (!job) return;
  const auto rendered = job->rendering.find(still);
  job->arrived.emplace(rendered->second, std::move(image));
  job->rendering.erase(rendered);
  // The encoders may overtake each other.
  while (job->active() && !job->arrived.empty() && job->arrived.begin()->first == job->given)
    give(*job, std::move(job->arrived.extract(job->arrived.begin()).mapped()));
  go_on();
}

void Jobs::give(Job& job, EncodedFrame image) {
  const std::uint64_t size = image.bytes.size() - image.front;
  if (bytes() + size > max_bytes_)
    return end(job, JobState::failed,
               "The results of jobs fill their room (job_results_mib): delete some, or ask for less.");
  job.bytes += size;
  ++job.given;
  disk_->run([result = job.result, open = job.plan.open_result, file = job.file, id = job.id, post = post_,
              shared = std::make_shared<const EncodedFrame>(std::move(image))] {
    result->attempt(id, post, [&] {
      if (!result->container) result->container = open(file);
      result->container->add(*shared);
      return std::uint64_t{0};
    });
  });
}

void Jobs::finish_result(Job& job) {
  disk_->run([result = job.result, file = job.file, id = job.id, post = post_] {
    result->attempt(id, post, [&] {
      result->container->finish();
      result->container.reset();
      return std::filesystem::file_size(file);
    });
  });
}

void Jobs::read(const JobNews& news) {
  Job* job = find_active(news.id);
  if (!job) return;
  if (!news.error.empty()) {
    end(*job, JobState::failed, "The result could not be written: " + news.error);
  } else if (news.result_bytes > 0) {
    job->bytes = news.result_bytes;
    end(*job, JobState::done);
  } else {
    metrics_.count(metric::job_frames);
    job->share = 0;
    if (++job->written == job->plan.frames) finish_result(*job);
  }
  go_on();
}

void Jobs::fail(StreamId still, const std::string& message) {
  Job* job = find_by_still(still);
  if (!job) return;
  end(*job, JobState::failed,
      "Frame " + std::to_string(job->rendering.at(still)) + " of the job, from 0, could not be rendered: " + message);
  go_on();
}

void Jobs::end(Job& job, JobState state, const std::string& error) {
  for (const auto& [still, index] : job.rendering) scheduler_.cancel_still(still);
  job.rendering.clear();
  job.arrived.clear();
  job.state = state;
  job.error = error;
  job.ended = clock_();
  metrics_.count(metric::jobs_ended(name_of(state)));
  // The file goes with what wrote it, unless it is whole; on the disk's thread, after what was given before.
  if (state != JobState::done) job.bytes = 0;
  disk_->run([result = std::move(job.result)]() mutable { result->failed = true, result->container.reset(); });
}

void Jobs::drop_file(Job& job) {
  if (job.state == JobState::done)
    disk_->run([file = job.file] {
      std::error_code ignored;
      std::filesystem::remove(file, ignored);
    });
}

void Jobs::forget_expired() {
  const JobTime now = clock_();
  auto ended = static_cast<std::size_t>(std::ranges::count_if(jobs_, [](const Job& job) { return !job.active(); }));
  const std::size_t before = ended;
  for (auto job = jobs_.begin(); job != jobs_.end();) {
    if (job->active() || (expires(*job) > now && ended <= max_ended)) {
      ++job;
      continue;
    }
    drop_file(*job);
    job = jobs_.erase(job);
    --ended;
  }
  if (ended != before) publish();
}

void Jobs::stop() {
  for (Job& job : jobs_)
    if (job.active()) end(job, JobState::cancelled, "The server stops.");
  publish();
}

void Jobs::close() {
  stop();
  if (disk_) disk_->wait();
}

std::uint64_t Jobs::bytes() const {
  std::uint64_t sum = 0;
  for (const Job& job : jobs_) sum += job.bytes;
  return sum;
}

void Jobs::publish() const {
  for (const auto state :
       {JobState::queued, JobState::rendering, JobState::done, JobState::failed, JobState::cancelled})
    metrics_.set(metric::jobs(name_of(state)), static_cast<double>(std::ranges::count(jobs_, state, &Job::state)));
  metrics_.set(metric::job_result_bytes, static_cast<double>(bytes()));
}

}  // namespace cloudscape::net
