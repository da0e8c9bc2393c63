// One viewer: the view it wants, the frame in render for it, what is in flight to it, and what its next frame is.
#pragma once
#include <optional>

#include "core/beside_frames.h"
#include "stream/flights.h"
#include "stream/frame_meter.h"
#include "stream/frame_scheduler.h"
#include "stream/quality_control.h"

namespace cloudscape::stream {

class ViewerStream {
 public:
  ViewerStream(StreamId id, const StreamView& view, const SchedulerOptions& options, Time now);

  bool update(const StreamView& view, Time now);  // whether a yielded refinement was abandoned for it
  std::optional<Flights::Acknowledged> acknowledge(std::uint32_t frame_id, double decode_ms, Time now);
  bool dropped(std::uint32_t frame_id);  // false: it is not in flight
  StreamStats stats(Time now) const;
  std::size_t in_flight() const { return flights_.size(); }

  // From when on `take` has a frame; nullopt: not before something else happens.
  std::optional<Time> ready_at() const;
  Work take(Time now);
  bool in_render(const Work& work) const { return work_ && work_->frame_id == work.frame_id; }
  bool wanted(const Work& work) const;
  bool yield(const Work& work);  // false: it is not wanted, and forgotten
  // `turn_ms`: what a frame takes with those of all streams that move now, each in its turn. false: it is not in
  // render.
  bool rendered(const Work& work, double render_ms, double turn_ms, Time now);
  bool moves(Time now) const;  // or did so lately
  void encoded(const Work& work, std::size_t bytes, double encode_ms, Time now);
  bool failed(const Work& work);  // false: it is neither in render nor in flight

 private:
  Time rested_at() const;
  bool steadying() const;
  Work steadying_frame();
  bool runs() const { return view_.clock && view_.clock->rate != 0; }  // time alone moves the view
  bool is_shown() const;                                               // but for a time that runs
  Work moving_frame(Time now);
  Work refining_frame() const;
  Work next_frame(FrameRequest request, const Encoding& encoding) const;
  void forget_work();
  void abandon();

  StreamId id_;
  StreamView view_;
  std::optional<StreamView> shown_;     // by the last frame that was taken
  std::optional<MovingPicture> flown_;  // until it is refined
  bool moved_ = true;                   // the view is not the one that is shown
  Time moved_since_;                    // the first change of the view that no frame shows yet
  Time moved_at_;                       // the last change
  Time rendered_at_;
  Time clock_due_;  // when the next picture of a running clock is due
  Time::duration clock_pace_;
  std::optional<Work> work_;  // in render or yielded
  bool yielded_ = false;
  std::uint32_t next_frame_id_ = 1;
  std::uint32_t view_frame_id_ = 1;  // the first frame of the view that is shown
  std::uint64_t sequence_ = 0;
  int accumulated_ = 0;  // samples in the average of the view that is shown
  int steadied_ = 0;     // moving frames of the view that is shown, after its first
  bool given_up_ = false;
  double render_ms_ = 0, encode_ms_ = 0;
  std::uint64_t dropped_ = 0;
  Flights flights_;
  FrameMeter meter_;
  DetailControl detail_;
  JpegControl jpeg_;
};

}  // namespace cloudscape::stream
