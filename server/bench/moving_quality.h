// How true the pictures of a moving stream are: frame by frame, from the very requests that it makes, one after the
// other in one stream, so that what the renderer keeps from frame to frame is as in flight.
#pragma once
#include <functional>
#include <vector>

#include "bench/flicker.h"
#include "settings/camera_path.h"
#include "stream/frame_scheduler.h"

namespace cloudscape::bench {

constexpr double moving_fps = 30;    // frames of path time
constexpr int leg_frames = 30;       // of a leg: a second of flight
constexpr int compared_every = 10;   // frames
constexpr int flicker_warm_up = 10;  // frames that are drawn and do not count, for what builds up from frame to frame
constexpr double pan_deg_per_s = 1;  // slow enough that the eye follows, and sees every flicker

// Pieces of the flight, evenly over the path.
struct Leg {
  double begin_s = 0;  // on the path
  int frames = 0;
};
// `step_s`: of path time from frame to frame. As many legs as asked for, or the whole path as one.
std::vector<Leg> legs_of(double begin_s, double end_s, double step_s, int legs);

struct QualityRun {
  stream::StreamView view;  // but for its pose and field of view
  settings::CameraPath path;
  double speed = 1;  // path seconds of a second
  int detail = 0;    // of stream::moving_details
  int legs = 8;
  int truth_samples = 16;
  int flicker_frames = 60;  // 0: flicker is not measured
  double flicker_at_s = 0;  // where on the path
  ImageSize flicker_size_px;
  std::function<Frame(const FrameRequest&)> draw;
  std::function<void(StreamId)> forget;
  std::function<void(double)> progress = [](double) {};
};

struct ComparedFrame {
  double time_s = 0;  // on the path
  double flip = 0;    // mean LDR-FLIP, at flip_pixels_per_degree
  double psnr_db = 0;
};

struct MovingQuality {
  int detail = 0;  // of stream::moving_details
  std::vector<ComparedFrame> compared;
  FlickerFigure still, pan;
  std::vector<PassTime> passes;  // sums over all moving frames of the legs
  int timed_frames = 0;
};

MovingQuality judge_moving(const QualityRun& run);

// The truth of a moving frame: the same view with the same steps, every pixel marched, `samples` averaged, nothing
// kept, nothing smoothed, and no dither.
FrameRequest truth_of(const FrameRequest& moving, int samples);
// As displayed, before the encoder.
Picture shown_picture(const Frame& frame);
// Adds up times of the same name.
void add_passes(std::vector<PassTime>& sums, const std::vector<PassTime>& passes);

}  // namespace cloudscape::bench
