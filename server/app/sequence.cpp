// `cloudscape still --path`: frames along a camera path, a file each. One is rendered while others are encoded.
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "app/encode_pool.h"
#include "app/frame_progress.h"
#include "app/still_options.h"
#include "core/error.h"
#include "core/log.h"
#include "encode/encode.h"
#include "encode/whole_image.h"
#include "settings/frame_pattern.h"
#include "settings/sequence_request.h"
#include "settings/text_file.h"

namespace cloudscape::app {
namespace {

settings::SequenceRequest sequence_request(const StillOptions& options) {
  for (const char* given : {"position", "azimuth_deg", "elevation_deg", "roll_deg", "vertical_fov_deg"})
    if (options.parameters.contains(given))
      throw InvalidInput("--path", std::string("gives the camera's ") + given + ": leave that option out");
  settings::FrameRange range;
  range.frames_per_second = options.frames_per_second;
  if (!options.frames.empty()) settings::read_frames(options.frames, range);
  return settings::sequence_of(still_request(options), settings::find_camera_path(options.path), range, "--frames");
}

volatile std::sig_atomic_t stop_signal = 0;

// Between these the first SIGINT or SIGTERM only asks for an end; the next one ends the program at once.
class StopBetweenFrames {
 public:
  StopBetweenFrames() {
    struct sigaction action {};
    action.sa_handler = [](int signal) { stop_signal = signal; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
  }
  ~StopBetweenFrames() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }
};

// Encodes and writes frames on threads of its own; the first error is kept.
class FrameWriter {
 public:
  explicit FrameWriter(const Encoding& encoding) : encoding_(encoding) {}

  // Waits while many frames wait already. Throws what a frame before met.
  void write(Frame frame, const std::string& file) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_ < most_waiting; });
    if (failure_) std::rethrow_exception(failure_);
    ++waiting_;
    lock.unlock();
    pool_.run([this, file, shared = std::make_shared<Frame>(std::move(frame))] { encode(*shared, file); });
  }
  // Waits for all. Throws as write.
  void finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_ == 0; });
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void encode(const Frame& frame, const std::string& file) {
    std::exception_ptr failure;
    try {
      settings::write_whole_file(file, encode::encode(frame, encoding_).bytes);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = failure;
    --waiting_;
    changed_.notify_all();
  }

  // tuned: enough to keep the encoders at work, and no more frames in memory than that.
  static constexpr int threads = 2, most_waiting = 4;
  const Encoding encoding_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int waiting_ = 0;
  std::exception_ptr failure_;
  EncodePool pool_{threads};  // the last member: its threads end before what they use
};

// False: a signal came, and the frame is not rendered to its end.
bool render(GpuStack& stack, const FrameRequest& request, FrameWriter& writer, const std::string& file) {
  auto job = stack.renderer.begin(request);
  while (!stop_signal && !stack.renderer.advance(*job)) {
  }
  if (stop_signal) {
    stack.renderer.abandon(std::move(job));
    return false;
  }
  writer.write(stack.renderer.collect(stack.renderer.finish(std::move(job))), file);
  return true;
}

// The frames that have no whole file yet.
std::vector<int> missing(const settings::SequenceRequest& sequence, const settings::FramePattern& pattern) {
  std::vector<int> numbers;
  for (int number = sequence.range.first; number <= *sequence.range.last; ++number)
    if (!encode::is_whole_image(pattern.file(number), sequence.still.encoding.format, sequence.still.frame.size_px))
      numbers.push_back(number);
  return numbers;
}

std::vector<int> all(const settings::SequenceRequest& sequence) {
  std::vector<int> numbers(static_cast<std::size_t>(sequence.frames()));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = sequence.range.first + static_cast<int>(i);
  return numbers;
}

}  // namespace

int run_sequence(const StillOptions& options) {
  const settings::SequenceRequest sequence = sequence_request(options);
  const settings::FramePattern pattern(options.output);
  settings::check_writable(pattern.file(sequence.range.first));
  const std::vector<int> numbers = options.resume ? missing(sequence, pattern) : all(sequence);
  const int kept = sequence.frames() - static_cast<int>(numbers.size());
  std::unique_ptr<GpuStack> stack;
  if (!numbers.empty()) stack = std::make_unique<GpuStack>(options.gpu, progress_on_stderr());
  const StopBetweenFrames stop;
  FrameWriter writer(sequence.still.encoding);
  FrameProgress progress(sequence.frames(), kept);
  int rendered = 0;
  for (const int number : numbers) {
    if (!render(*stack, sequence.frame(number), writer, pattern.file(number))) break;
    ++rendered;
    progress.rendered();
  }
  progress.end();
  writer.finish();
  if (!stop_signal) return 0;
  std::fprintf(stderr, "cloudscape: stopped after %d of %d frames: --resume goes on from there\n", kept + rendered,
               sequence.frames());
  return 128 + stop_signal;
}

}  // namespace cloudscape::app
