// Who gets the next frame. Each stream (viewer), and all stills together, have the same share of the renderer's time,
// not of its frames: who asks for large ones gets fewer (turns.h). A stream's newest view wins; what is in flight to a
// viewer is bounded by its acknowledgements; a view at rest is refined and then costs nothing. No sockets, no GL. Every
// function may be called from any thread; only `take` waits. What names an unknown or finished stream, still or frame
// is ignored.
//
// Moving: a view that changed is answered with a coarse frame (stage 0) whose cost follows the measured render time and
// whose JPEG quality follows the measured link. Such a frame is always finished, so that a viewer who never rests sees
// something. Resting: once the view stood still, frames of full quality continue one average (`first_sample` samples
// are in it, `quality.samples` are added) until the quality's sample count is reached, each when the one before is
// acknowledged; a change of the view abandons the one in render. A view whose clock runs never rests: it is answered
// with moving frames, `target_frame_ms` apart where nothing else moves it.
//
// Background: frames of long jobs. They get the turns that nobody else wants: only when no stream or still was rendered
// for a moment, since a slice between two frames of a moving stream would cost it a frame, and otherwise a slice now
// and then, so that a job ends however long somebody flies.
//
// Metrics, counters: cloudscape_frames_rendered_total{kind="stream"|"still"|"background"},
// cloudscape_frames_dropped_total{reason="replaced"|"abandoned"|"failed"} (before the socket took it; in render, for
// its view changed; by an error), cloudscape_stills_cancelled_total, cloudscape_stills_refused_total. Gauges:
// cloudscape_streams_open, cloudscape_stills_waiting (in render included), cloudscape_frames_in_flight. Histograms:
// cloudscape_queue_ms (wanted until taken), cloudscape_render_ms, cloudscape_encode_ms, cloudscape_ack_ms (encoded
// until acknowledged, without decoding).
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "core/clock.h"
#include "core/frame.h"
#include "core/metrics.h"

namespace cloudscape::stream {

using Time = std::chrono::steady_clock::time_point;

// What a viewer wants to see now.
struct StreamView {
  std::shared_ptr<const Cloudscape> cloudscape;
  CameraPose pose;
  Lens lens;
  Display display;
  March march;
  ImageSize size_px;
  Quality quality = Quality::standard;  // that a resting view is refined to
  double time_s = 0;
  std::optional<RunningTime> clock;  // that shows the time instead; while it runs the view moves
  std::uint64_t pose_sequence = 0;   // of the client's message that set it
};

struct SchedulerOptions {
  double target_frame_ms = 33;   // of a moving view: its detail adapts to it, and a running clock is shown so often
  std::size_t still_queue = 16;  // stills that wait or render; one more is refused
  int max_in_flight = 3;         // frames of one stream without acknowledgement, at most
  // tuned: longer than the pause in which a moving stream waits for its acknowledgement.
  double background_quiet_ms = 250;
  // tuned: a slice of 60 ms in two seconds is 3 % of the renderer.
  double background_patience_ms = 2000;
  std::size_t first_detail = 3;  // of a new stream's moving frames, of `moving_details`
};

// One frame to render. `request` is complete: quality, sample count and sequence included. `request.sequence` counts
// the frames of a stream, from 0; it is 0 in a still.
struct Work {
  FrameRequest request;
  Encoding encoding;
  bool still = false;          // a still, or a frame of the background: deliver once, whole
  std::uint32_t frame_id = 0;  // streams: acknowledged by the viewer
  std::uint64_t pose_sequence = 0;
  std::uint8_t quality_stage = 0;  // 0 moving, 1.. refining, 255 final
  Time queued;                     // since when it was wanted
};

// Of the last two seconds, or the newest value there is.
struct StreamStats {
  double frames_per_second = 0, bits_per_second = 0, round_trip_ms = 0, render_ms = 0, encode_ms = 0;
  std::uint64_t frames_dropped = 0;  // replaced before the socket took them, since the stream was opened
  int window = 0;                    // frames that may be in flight now
};

class FrameScheduler {
 public:
  using Clock = std::function<Time()>;
  FrameScheduler(SchedulerOptions options, Metrics& metrics, Clock clock = std::chrono::steady_clock::now);
  ~FrameScheduler();

  // Viewers (network thread).
  StreamId open(const StreamView& view);
  void update(StreamId stream, const StreamView& view);
  void acknowledge(StreamId stream, std::uint32_t frame_id, double decode_ms);
  void close(StreamId stream);
  // The frame was replaced by a newer one before its socket took it: it will never be acknowledged.
  void dropped(StreamId stream, std::uint32_t frame_id);
  StreamStats stats(StreamId stream) const;

  // Stills. The id names it in `Work::request.stream`; nullopt: the queue is full.
  std::optional<StreamId> submit_still(FrameRequest request, const Encoding& encoding);
  void cancel_still(StreamId still);  // or a frame of the background
  std::size_t stills_waiting() const;
  // A still of the background; whoever submits bounds how many there are. They are begun in the order of submission.
  // nullopt: stopped.
  std::optional<StreamId> submit_background(FrameRequest request, const Encoding& encoding);

  // Render thread. `take` waits until something can be rendered, or `deadline`, or stop().
  std::optional<Work> take(Time deadline);
  // The work is not done yet but others may go first: false if nobody wants it any more (view changed, closed,
  // cancelled), else it comes back from a later `take`, the same value.
  bool yield(const Work& work);
  // Whether somebody still waits for this taken or yielded work. A yielded work that nobody wants does not come back
  // from `take`: drop what is kept for it.
  bool wanted(const Work& work) const;
  // The frame is rendered; `bytes` and `encode_ms` follow from the encoder through `encoded`.
  void rendered(const Work& work, const FrameTimings& timings);
  void encoded(const Work& work, std::size_t bytes, double encode_ms);
  // The render, or later the encoder, failed; the stream goes on with its next view.
  void failed(const Work& work);

  bool is_open(StreamId stream) const;  // a viewer's stream that was opened and not closed
  bool stopped() const;
  void stop();  // `take` returns nullopt from now on, at once

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cloudscape::stream
