// The life of jobs, with the disk's thread and the network's news done by hand and a clock that the test moves.
#include "net/jobs.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "net/byte_range.h"
#include "site_fixture.h"

namespace cloudscape::net {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Writes each frame's bytes one after the other; fails where `broken`.
class PlainFile : public FrameContainer {
 public:
  PlainFile(fs::path path, const bool& broken) : path_(std::move(path)), broken_(broken) { std::ofstream{path_}; }
  ~PlainFile() override {
    if (!finished_) fs::remove(path_);
  }
  void add(const EncodedFrame& image) override {
    if (broken_) throw Error("the disk is full");
    std::ofstream(path_, std::ios::app | std::ios::binary)
        .write(reinterpret_cast<const char*>(image.bytes.data()), static_cast<std::streamsize>(image.bytes.size()));
  }
  void finish() override { finished_ = true; }

 private:
  fs::path path_;
  const bool& broken_;
  bool finished_ = false;
};

class JobsTest : public SiteTest {
 protected:
  JobsTest() { settings_.jobs_dir = folder_; }
  ~JobsTest() override {
    jobs_.reset();
    fs::remove_all(folder_);
  }
  void make_jobs() {
    make();
    const JobParts parts{[this](Task task) { task(); }, {}};
    jobs_.emplace(Parts{settings_, *scheduler_, library_, metrics_, page_, parts}, [this] { return now_; });
    jobs_->on_news([this](JobNews told) { news_.push_back(std::move(told)); });
  }
  const Job* order(int frames, const std::string& client = "a") {
    JobPlan plan;
    plan.kind = "test";
    plan.frames = frames;
    plan.frame = [](int index) {
      FrameRequest request;
      request.time_s = index;
      return request;
    };
    plan.open_result = [this](const fs::path& path) { return std::make_unique<PlainFile>(path, broken_); };
    const auto ordered = jobs_->order(client, std::move(plan));
    if (const auto* refused = std::get_if<Response>(&ordered)) refused_ = refused->status;
    return std::holds_alternative<const Job*>(ordered) ? std::get<const Job*>(ordered) : nullptr;
  }
  std::optional<stream::Work> take() { return scheduler_->take(stream::Time{}); }
  static EncodedFrame image(char content) { return {{static_cast<std::uint8_t>(content)}, 0, ImageFormat::jpeg, 0}; }
  void deliver(const stream::Work& work, EncodedFrame frame) {
    scheduler_->rendered(work, {});
    jobs_->deliver(work.request.stream, std::move(frame));
  }
  void read_news() {
    for (const JobNews& each : std::exchange(news_, {})) jobs_->read(each);
  }
  void render_all() {
    for (int left = 1000; left > 0; --left, read_news())
      if (const auto work = take())
        deliver(*work, image(static_cast<char>('a' + static_cast<int>(work->request.time_s))));
      else if (news_.empty())
        return;
  }
  std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) count += entry.is_regular_file();
    return count;
  }
  static std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const std::string folder_ = (fs::temp_directory_path() / ("cloudscape-jobs-test-" + random_hex())).string();
  JobTime now_{std::chrono::hours(480'000)};
  bool broken_ = false;
  int refused_ = 0;
  std::vector<JobNews> news_;
  std::optional<Jobs> jobs_;
};

TEST_F(JobsTest, goes_from_queued_to_done_and_expires) {
  make_jobs();
  const Job* job = order(5);
  ASSERT_TRUE(job);
  EXPECT_EQ(job->id.size(), 32u);
  EXPECT_EQ(jobs_->find(job->id), job);
  EXPECT_EQ(jobs_->find(std::string(32, '0')), nullptr);
  render_all();
  EXPECT_EQ(job->state, JobState::done);
  EXPECT_EQ(job->written, 5);
  EXPECT_EQ(job->bytes, 5u);
  EXPECT_EQ(text_of(job->file), "abcde");
  EXPECT_EQ(metrics_.value("cloudscape_jobs{state=\"done\"}"), 1);
  EXPECT_EQ(metrics_.value("cloudscape_job_frames_total"), 5);
  now_ += std::chrono::seconds(3599);
  jobs_->forget_expired();
  const std::string id = job->id;
  EXPECT_TRUE(jobs_->find(id));
  now_ += std::chrono::seconds(1);
  jobs_->forget_expired();
  EXPECT_FALSE(jobs_->find(id));
  EXPECT_EQ(files(), 0u);
}

TEST_F(JobsTest, has_few_frames_at_the_scheduler_and_writes_them_in_order) {
  make_jobs();
  const Job* job = order(4);
  const auto first = take(), second = take();
  EXPECT_EQ(job->rendering.size(), 3u);
  deliver(*second, image('2'));
  EXPECT_EQ(job->given, 0) << "the first one is missing";
  deliver(*first, image('1'));
  EXPECT_EQ(job->given, 2);
  EXPECT_EQ(job->written, 0) << "until the disk's thread tells";
  EXPECT_EQ(job->submitted, 3);
  read_news();
  EXPECT_EQ(job->written, 2);
  EXPECT_EQ(job->submitted, 4);
  EXPECT_EQ(text_of(job->file), "12");
}

TEST_F(JobsTest, knows_the_samples_of_the_frame_that_is_next) {
  make_jobs();
  const Job* job = order(4);
  const auto first = take(), second = take();
  jobs_->note_samples(first->request.stream, 0.5, 32);
  EXPECT_DOUBLE_EQ(job->progress(), 0.125);
  EXPECT_EQ(job->samples, 32);
  jobs_->note_samples(second->request.stream, 0.75, 48);
  jobs_->note_samples(12345, 0.75, 48);
  EXPECT_DOUBLE_EQ(job->progress(), 0.125);
  deliver(*first, image('1'));
  read_news();
  EXPECT_DOUBLE_EQ(job->progress(), 0.25);
}

TEST_F(JobsTest, third_job_waits_until_one_of_two_ends) {
  settings_.max_jobs = 6;
  make_jobs();
  const Job *first = order(9), *second = order(9), *third = order(9);
  EXPECT_EQ(first->state, JobState::rendering);
  EXPECT_EQ(second->state, JobState::rendering);
  EXPECT_EQ(third->state, JobState::queued);
  EXPECT_TRUE(jobs_->remove(first->id));
  EXPECT_EQ(third->state, JobState::rendering);
}

TEST_F(JobsTest, limits_of_a_client_and_of_all) {
  make_jobs();
  order(9), order(9);
  EXPECT_FALSE(order(9));
  EXPECT_EQ(refused_, 429);
  EXPECT_TRUE(order(9, "b") && order(9, "b"));
  EXPECT_FALSE(order(9, "c"));
  EXPECT_EQ(refused_, 503);
  EXPECT_EQ(metrics_.value("cloudscape_refused_total{reason=\"jobs\"}"), 2);
}

TEST_F(JobsTest, cancelled_job_leaves_neither_file_nor_frames) {
  make_jobs();
  const Job* job = order(9);
  const auto work = take();
  deliver(*work, image('1'));
  read_news();
  EXPECT_EQ(files(), 1u);
  const auto rendering = take();
  EXPECT_TRUE(jobs_->remove(job->id));
  EXPECT_EQ(files(), 0u);
  EXPECT_FALSE(scheduler_->wanted(*rendering));
  EXPECT_FALSE(take());
  jobs_->deliver(rendering->request.stream, image('2'));
  jobs_->fail(rendering->request.stream, "too late");
  EXPECT_EQ(metrics_.value("cloudscape_jobs_ended_total{state=\"cancelled\"}"), 1);
}

TEST_F(JobsTest, failures_of_renderer_disk_and_room_end_it_with_a_sentence) {
  settings_.job_results_mib = 1;
  make_jobs();
  const Job* rendering = order(2);
  jobs_->fail(take()->request.stream, "the device is lost");
  EXPECT_EQ(rendering->state, JobState::failed);
  EXPECT_NE(rendering->error.find("the device is lost"), std::string::npos);
  broken_ = true;
  const Job* writing = order(2);
  render_all();
  EXPECT_EQ(writing->state, JobState::failed);
  EXPECT_NE(writing->error.find("the disk is full"), std::string::npos);
  broken_ = false;
  const Job* large = order(2);
  deliver(*take(), {std::vector<std::uint8_t>(2 << 20), 0, ImageFormat::jpeg, 0});
  EXPECT_EQ(large->state, JobState::failed);
  EXPECT_NE(large->error.find("job_results_mib"), std::string::npos);
  EXPECT_EQ(files(), 0u);
  EXPECT_EQ(metrics_.value("cloudscape_job_result_bytes"), 0);
}

TEST_F(JobsTest, stop_cancels_what_is_at_work_and_the_folder_goes) {
  make_jobs();
  const Job* done = order(1);
  render_all();
  const Job* active = order(3);
  jobs_->stop();
  EXPECT_EQ(done->state, JobState::done);
  EXPECT_EQ(active->state, JobState::cancelled);
  EXPECT_NE(active->error, "");
  jobs_.reset();
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(JobsTest, left_behind_folders_are_removed_and_living_ones_kept) {
  fs::create_directories(folder_ + "/cloudscape-jobs-dead/deep");
  fs::create_directories(folder_ + "/other");
  const JobFolder living(folder_);
  EXPECT_FALSE(fs::exists(folder_ + "/cloudscape-jobs-dead"));
  EXPECT_TRUE(fs::exists(folder_ + "/other"));
  EXPECT_EQ(fs::status(living.path()).permissions(), fs::perms::owner_all);
  const JobFolder second(folder_);
  EXPECT_TRUE(fs::exists(living.path()));
}

TEST_F(JobsTest, without_a_folder_jobs_are_refused_but_the_server_lives) {
  make();  // its site has no disk's thread
  Request post = request(Method::post, "/api/v1/sequences");
  post.body = R"({"cloudscape": "overcast", "path": "fly-around"})";
  post.content_length = std::to_string(post.body.size());
  EXPECT_EQ(ask(post).status, 503);
  settings_.jobs_dir = "/proc/nowhere";
  EXPECT_THROW(make_jobs(), Error);
}

TEST(Router, part_may_stand_in_the_middle) {
  const Route job{"/jobs/{id}", false, {}}, result{"/jobs/{id}/result", false, {}};
  EXPECT_TRUE(result.matches("/jobs/7/result"));
  EXPECT_EQ(result.name_in("/jobs/7/result"), "7");
  EXPECT_FALSE(job.matches("/jobs/7/result"));
  for (const char* path : {"/jobs//result", "/jobs/result", "/jobs/7/8/result", "/jobs/7/results", "/jobs/7"})
    EXPECT_FALSE(result.matches(path)) << path;
}

TEST(ByteRange, one_range_is_answered_and_the_rest_passed_over) {
  const auto ask = [](std::string range, std::string if_range = "") {
    Request request;
    request.range = std::move(range), request.if_range = std::move(if_range);
    return ranged(request, text_response(200, "text/plain", "0123456789"), "\"tag\"");
  };
  const auto part = [&](const char* range) { return std::string(ask(range).body.bytes); };
  EXPECT_EQ(part("bytes=2-4"), "234");
  EXPECT_EQ(part("bytes=7-"), "789");
  EXPECT_EQ(part("bytes=7-99"), "789");
  EXPECT_EQ(part("bytes=-3"), "789");
  EXPECT_EQ(part("bytes=-99"), "0123456789");
  EXPECT_EQ(ask("bytes=0-0").status, 206);
  for (const char* whole : {"", "bytes=4-2", "bytes=a-b", "bytes=1-2,4-5", "lines=1-2", "bytes=-", "bytes=", "bytes=1"})
    EXPECT_EQ(ask(whole).status, 200) << whole;
  EXPECT_EQ(ask("bytes=2-4", "\"tag\"").status, 206);
  EXPECT_EQ(ask("bytes=2-4", "\"old\"").status, 200);
  for (const char* outside : {"bytes=10-", "bytes=-0"}) EXPECT_EQ(ask(outside).status, 416) << outside;
}

}  // namespace
}  // namespace cloudscape::net
