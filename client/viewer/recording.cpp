// The loop of a flight without a window: poses go out, frames come in and are saved.
#include "viewer/recording.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/log.h"
#include "settings/camera_path.h"
#include "viewer/hello.h"
#include "viewer/report.h"
#include "viewer/stream_client.h"

namespace cloudscape::viewer {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr double connection_patience_s = 15.0;  // tuned: a restart of the server is survived, a dead one noticed
constexpr double least_fov_change_deg = 1e-6;   // what a spline through equal keys errs by, and more
constexpr double frame_patience_s = 120.0;      // as long as the server gives a still

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw Error("The file " + path.string() + " cannot be written.");
}

std::filesystem::path make_folder(const std::string& name) {
  std::error_code error;
  std::filesystem::create_directories(name, error);
  if (error) throw Error("The folder " + name + " cannot be made: " + error.message() + ".");
  return name;
}

class Recording {
 public:
  explicit Recording(const Options& options)
      : options_(options),
        path_(settings::parse_camera_path(read_file(options.path), options.path)),
        folder_(make_folder(options.out)),
        client_(options.endpoint, first_settings(options), connection_patience_s, [] {}) {}

  void run() {
    wait_for_welcome();
    start_ = last_news_ = steady_clock::now();
    while (!finished()) {
      if (pose_is_due()) send_pose();
      if (const auto picture = client_.take_picture(next_look())) show(*picture);
      check_progress();
    }
    record_.duration_s = duration<double>(last_news_ - start_).count();
    record_.latency_ms = latency_.all_ms();
    const std::string report = report_json(record_, client_.status(), authority(options_.endpoint));
    write_file(folder_ / "report.json", {reinterpret_cast<const std::uint8_t*>(report.data()), report.size()});
  }

 private:
  // Frames of the document's own view, before the first pose, are acknowledged and left out.
  void wait_for_welcome() {
    last_news_ = steady_clock::now();
    while (!client_.status().welcome) {
      if (const auto picture = client_.take_picture(next_look())) client_.displayed(*picture);
      check_progress();
    }
  }

  bool finished() const { return sent_ == static_cast<std::uint64_t>(options_.frames) && shown_ == sent_; }

  Time due() const {
    return start_ + std::chrono::duration_cast<steady_clock::duration>(duration<double>(path_time_s()));
  }
  double path_time_s() const { return static_cast<double>(sent_) / options_.fps; }

  bool pose_is_due() const {
    if (sent_ == static_cast<std::uint64_t>(options_.frames)) return false;
    return options_.live ? steady_clock::now() >= due() : shown_ == sent_;
  }

  // The time until which nothing but a picture can happen.
  Time next_look() const {
    const Time soon = steady_clock::now() + std::chrono::milliseconds(100);
    return options_.live && sent_ < static_cast<std::uint64_t>(options_.frames) ? std::min(due(), soon) : soon;
  }

  // The sky's time goes with the path's, so that each pose is a new view even where the path rests.
  void send_pose() {
    const double time_s = path_time_s();
    const settings::CameraPath::Key key = settings::key_at(path_, path_.keys.front().time_s + time_s);
    look_through(key.vertical_fov_deg);
    const Time now = steady_clock::now();
    sent_ = client_.look(key.pose, time_s);
    latency_.sent(sent_, now);
    record_.poses_sent = sent_;
  }

  void look_through(double vertical_fov_deg) {
    if (lens_ && std::abs(lens_->vertical_fov_deg - vertical_fov_deg) < least_fov_change_deg) return;
    lens_ = Lens{};
    lens_->vertical_fov_deg = vertical_fov_deg;
    wire::Settings settings;
    settings.lens = lens_;
    client_.change(settings);
  }

  void show(const Picture& picture) {
    last_news_ = steady_clock::now();
    client_.displayed(picture);
    const wire::FrameHeader& header = picture.frame.header;
    if (!latency_.displayed(header.pose_sequence, last_news_)) {
      if (header.pose_sequence > 0) ++record_.refinements;
      return;
    }
    shown_ = header.pose_sequence;
    record_.decode_ms.push_back(picture.decode_ms);
    record_.render_ms.push_back(header.render_ms);
    record_.encode_ms.push_back(header.encode_ms);
    save(picture.frame);
  }

  void save(const ReceivedFrame& frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04llu.jpg", static_cast<unsigned long long>(++record_.frames));
    write_file(folder_ / name, frame.image());
  }

  void check_progress() const {
    if (const auto failure = client_.failure()) throw Error(*failure);
    if (milliseconds_between(last_news_, steady_clock::now()) > frame_patience_s * 1000)
      throw Error("The server at " + authority(options_.endpoint) + " sent no frame for " +
                  std::to_string(static_cast<int>(frame_patience_s)) + " s.");
  }

  const Options& options_;
  const settings::CameraPath path_;
  const std::filesystem::path folder_;
  StreamClient client_;
  LatencyMeter latency_;
  FlightRecord record_;
  std::optional<Lens> lens_;  // that the server was told
  Time start_, last_news_;
  std::uint64_t sent_ = 0, shown_ = 0;  // pose sequences
};

}  // namespace

void record_flight(const Options& options) { Recording(options).run(); }

}  // namespace cloudscape::viewer
