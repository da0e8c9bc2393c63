// Jobs: work that takes longer than a client should wait for an answer. Each renders frames in the background, one
// after the other, and leaves one file. Whoever knows a job's id may see, fetch and delete it: the ids cannot be
// guessed and are listed nowhere.
//
//   queued -> rendering -> done        the result can be fetched until the job expires
//                       -> failed      with a sentence
//          -> cancelled                the server stops; a job that its client deletes is gone at once
//
// All on the network thread; files are written through the disk queue.
#pragma once
#include <algorithm>
#include <chrono>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "core/frame_container.h"
#include "core/metrics.h"
#include "net/disk_queue.h"
#include "net/http_response.h"
#include "net/job_folder.h"
#include "net/server.h"

namespace cloudscape::net {

enum class JobState { queued, rendering, done, failed, cancelled };
std::string_view name_of(JobState state);

// What a kind of job is to the jobs.
struct JobPlan {
  std::string kind;  // "sequence" or "reference"
  int frames = 1;
  std::function<FrameRequest(int index)> frame;  // 0 .. frames - 1
  Encoding encoding;
  std::function<std::unique_ptr<FrameContainer>(const std::filesystem::path&)> open_result;  // on the disk's thread
  std::string media_type, file_name;                                                         // of the result
  int samples = 1;                                                                           // of a frame, at most
};

using JobTime = std::chrono::system_clock::time_point;

struct Job {
  std::string id, client;
  JobPlan plan;
  JobState state = JobState::queued;
  std::string error;  // of a failed or cancelled one
  JobTime created, ended{};
  int submitted = 0, given = 0, written = 0;  // frames: to the scheduler, to the disk, on the disk
  std::uint64_t bytes = 0;                    // of the result, so far
  double share = 0;                           // of the frame under way, where it is path-traced
  int samples = 0;                            // that each of its pixels has
  std::filesystem::path file;

  std::map<StreamId, int> rendering;    // frames by their stills
  std::map<int, EncodedFrame> arrived;  // that a frame before is missing for
  struct Result;
  std::shared_ptr<Result> result;  // the file while it is written: used on the disk's thread only
  double progress() const { return std::min(1.0, (written + share) / plan.frames); }
  bool active() const { return state == JobState::queued || state == JobState::rendering; }
};

// What the disk's thread tells.
struct JobNews {
  std::string id;
  std::string error;               // it failed
  std::uint64_t result_bytes = 0;  // the result is whole; 0: one frame more is written
};

class Jobs {
 public:
  using Clock = std::function<JobTime()>;
  using Post = std::function<void(JobNews)>;
  // Throws Error where settings name a folder that cannot be used. Without `writers`, or a folder, no job is taken.
  Jobs(const Parts& parts, Clock clock = std::chrono::system_clock::now);
  ~Jobs() { close(); }

  // Called on the disk's thread: brings the news to `read`, on the network thread.
  void on_news(Post post) { post_ = std::move(post); }
  std::variant<const Job*, Response> order(const std::string& client, JobPlan plan);  // the refusal is 429 or 503
  const Job* find(std::string_view id) const;                                         // nullptr: there is none
  bool remove(std::string_view id);  // cancels where it is not done. false: there is none
  JobTime expires(const Job& job) const { return job.ended + kept_; }

  bool owns(StreamId still) const;  // it is a frame of a job at work
  void note_samples(StreamId still, double share, int samples);
  void deliver(StreamId still, EncodedFrame image);
  void fail(StreamId still, const std::string& message);
  void read(const JobNews& news);
  void forget_expired();
  void stop();   // cancels what is active
  void close();  // and waits for the disk

 private:
  Job* find_by_still(StreamId still);
  Job* find_active(std::string_view id);
  std::optional<Response> refusal(const std::string& client) const;
  void go_on();
  void submit(Job& job);
  void give(Job& job, EncodedFrame image);
  void finish_result(Job& job);
  void end(Job& job, JobState state, const std::string& error = "");
  void drop_file(Job& job);
  std::uint64_t bytes() const;
  void publish() const;

  stream::FrameScheduler& scheduler_;
  Metrics& metrics_;
  const std::size_t max_jobs_;
  const std::uint64_t max_bytes_;
  const JobTime::duration kept_;
  const Clock clock_;
  Post post_ = [](const JobNews&) {};
  std::optional<JobFolder> folder_;
  std::uint64_t last_file_ = 0;
  std::list<Job> jobs_;  // the oldest first
  std::optional<DiskQueue> disk_;
};

}  // namespace cloudscape::net
