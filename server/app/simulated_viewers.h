// Viewers in the program itself, for benchmarks: each sends the pose of a hand that flies along a path, at a fixed rate
// of the real clock, and acknowledges its frames; they note what arrives and when.
#pragma once
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/frame_pump.h"
#include "bench/flight_figures.h"
#include "settings/camera_path.h"

namespace cloudscape::app {

struct ViewersOptions {
  settings::CameraPath path;
  double speed = 1;  // path seconds of a second; at the path's ends they turn back
  double poses_per_s = 60;
  double latency_ms = 0;           // from the encoder until the acknowledgement; 0: at once
  double sun_deg_per_s = 0;        // by which somebody turns the sun about the zenith meanwhile
  double sun_climb_deg_per_s = 0;  // by which it rises, up to 60 degrees, and sets again, down to 5
};

class SimulatedViewers {
 public:
  struct Viewer {
    stream::StreamView view;  // but for its pose and field of view
    double start_s = 0;       // on the path
  };
  SimulatedViewers(stream::FrameScheduler& scheduler, ViewersOptions options, const std::vector<Viewer>& viewers);
  ~SimulatedViewers();  // after the pump that delivers to them

  FramePump::Sink sink();
  void measure_from_now();
  std::size_t delivered() const;  // frames since then, of all viewers
  double seconds() const;
  std::vector<std::vector<bench::FlownFrame>> frames() const;  // of each viewer, since then
  std::string failure() const;                                 // of the first frame that could not be rendered; or ""

 private:
  using Time = stream::Time;
  struct Each {
    Viewer viewer;
    std::vector<Time> sent;  // poses, by their sequence
    std::vector<bench::FlownFrame> frames;
  };
  struct Acknowledgement {
    Time due;
    StreamId stream;
    std::uint32_t frame_id;
  };
  void run();
  void send_poses(Time now);
  void acknowledge_due(Time now);
  void deliver(const stream::Work& work, const FrameTimings& timings, const EncodedFrame& image);
  stream::StreamView view_at(Each& each, Time now);
  std::shared_ptr<const Cloudscape> in_other_light(const Cloudscape& sky, double open_s) const;

  stream::FrameScheduler& scheduler_;
  const ViewersOptions options_;
  const Time opened_ = std::chrono::steady_clock::now();
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::map<StreamId, Each> viewers_;
  std::deque<Acknowledgement> acknowledgements_;  // in order of time
  Time measured_from_ = opened_;
  std::string failure_;
  bool stopping_ = false;
  std::thread thread_;
};

// Where on the path a hand is that began at `start_s`, after `flown_s` of path time: it turns back at the ends.
double place_on(const settings::CameraPath& path, double start_s, double flown_s);

}  // namespace cloudscape::app
