#include "stream/viewer_stream.h"

#include <algorithm>
#include <utility>

#include "core/milliseconds.h"
#include "stream/moving_frame.h"
#include "stream/refinement.h"

namespace cloudscape::stream {
namespace {

// tuned: pauses between two steps of a hand or of a slow network stay below it; a resting viewer waits for it.
constexpr std::chrono::milliseconds settle{150};

bool same_cloudscape(const std::shared_ptr<const Cloudscape>& a, const std::shared_ptr<const Cloudscape>& b) {
  return a == b || (a && b && *a == *b);
}

bool same_picture(const StreamView& a, const StreamView& b) {
  return a.pose == b.pose && a.lens == b.lens && a.display == b.display && a.march == b.march &&
         a.size_px == b.size_px && a.quality == b.quality && a.time_s == b.time_s && a.clock == b.clock &&
         same_cloudscape(a.cloudscape, b.cloudscape);
}

// As it is at that moment: its time stands.
StreamView snapshot(StreamView view, Time now) {
  if (view.clock) view.time_s = view.clock->at(now);
  view.clock.reset();
  return view;
}

}  // namespace

ViewerStream::ViewerStream(StreamId id, const StreamView& view, const SchedulerOptions& options, Time now)
    : id_(id),
      view_(view),
      moved_since_(now),
      moved_at_(now),
      rendered_at_(now),
      clock_due_(now),
      clock_pace_(std::chrono::duration_cast<Time::duration>(
          std::chrono::duration<double, std::milli>(options.target_frame_ms))),
      flights_(options.max_in_flight),
      meter_(now),
      detail_(options.target_frame_ms, options.first_detail),
      jpeg_(options.target_frame_ms) {}

bool ViewerStream::update(const StreamView& view, Time now) {
  if (!same_picture(view, view_)) moved_at_ = now;
  view_ = view;
  const bool moved = !is_shown();
  if (moved && !moved_) moved_since_ = now;
  moved_ = moved;
  if (!yielded_ || wanted(*work_)) return false;
  abandon();
  return true;
}

std::optional<Flights::Acknowledged> ViewerStream::acknowledge(std::uint32_t frame_id, double decode_ms, Time now) {
  const auto acknowledged = flights_.acknowledge(frame_id, decode_ms, now);
  if (acknowledged && acknowledged->queued_ms)
    jpeg_.acknowledged(*acknowledged->queued_ms, flights_.round_trip().frame_ms());
  return acknowledged;
}

bool ViewerStream::dropped(std::uint32_t frame_id) {
  if (!flights_.dropped(frame_id)) return false;
  jpeg_.dropped();
  ++dropped_;
  return true;
}

StreamStats ViewerStream::stats(Time now) const {
  return {meter_.frames_per_second(now),
          meter_.bits_per_second(now),
          flights_.round_trip().ms(),
          render_ms_,
          encode_ms_,
          dropped_,
          flights_.window()};
}

bool ViewerStream::is_shown() const {
  if (!shown_) return false;
  StreamView view = view_;
  if (runs()) view.time_s = shown_->time_s, view.clock.reset();
  return same_picture(snapshot(view, moved_at_), *shown_);
}

Time ViewerStream::rested_at() const { return std::max(moved_at_ + settle, rendered_at_); }

// A moving picture is put together from several frames: those of a view that has just come to rest follow at once, so
// that it is sharp before it is refined.
bool ViewerStream::steadying() const {
  return !moved_ && !given_up_ && accumulated_ == 0 && steadied_ + 1 < detail_.detail().reuse &&
         rendered_at_ < moved_at_ + settle;
}

std::optional<Time> ViewerStream::ready_at() const {
  if (work_) return yielded_ ? std::optional(work_->queued) : std::nullopt;
  if (moved_) return flights_.has_room() ? std::optional(moved_since_) : std::nullopt;
  if (runs()) return flights_.has_room() ? std::optional(clock_due_) : std::nullopt;
  if (steadying()) return flights_.has_room() ? std::optional(rendered_at_) : std::nullopt;
  // One refined frame at a time: they are large, and the next motion waits behind what is in flight.
  const bool refined = given_up_ || accumulated_ >= render_quality(marched(view_.quality)).samples;
  return refined || flights_.size() > 0 ? std::nullopt : std::optional(rested_at());
}

Work ViewerStream::take(Time now) {
  if (!work_) {
    work_ = moved_ || runs() ? moving_frame(now) : steadying() ? steadying_frame() : refining_frame();
    work_->queued = std::min(work_->queued, now);
    ++next_frame_id_;
    ++sequence_;
  }
  yielded_ = false;
  return *work_;
}

Work ViewerStream::next_frame(FrameRequest request, const Encoding& encoding) const {
  Work work;
  work.request = std::move(request);
  work.request.time_s = shown_->time_s;
  work.encoding = encoding;
  work.frame_id = next_frame_id_;
  work.pose_sequence = view_.pose_sequence;
  return work;
}

Work ViewerStream::moving_frame(Time now) {
  const Time since = moved_ ? moved_since_ : clock_due_;
  shown_ = snapshot(view_, now);
  moved_ = false;
  clock_due_ = now + clock_pace_;
  view_frame_id_ = next_frame_id_;
  accumulated_ = 0;
  steadied_ = -1;
  given_up_ = false;
  Work work = steadying_frame();
  work.queued = since;
  return work;
}

Work ViewerStream::steadying_frame() {
  ++steadied_;
  Work work = next_frame(moving_request(view_, id_, sequence_, detail_.detail()),
                         {ImageFormat::jpeg, jpeg_.quality(), ChromaSubsampling::half});
  work.quality_stage = moving_stage;
  work.queued = rendered_at_;
  return work;
}

Work ViewerStream::refining_frame() const {
  FrameRequest request = request_of(view_, id_, sequence_);
  request.quality = render_quality(marched(view_.quality));
  const RefinementStep step = refinement_step(accumulated_, request.quality.samples);
  request.quality.march_divisor = 1;
  request.quality.samples = step.samples;
  request.first_sample = step.first_sample;
  Work work = next_frame(std::move(request), step.encoding);
  work.quality_stage = step.stage;
  work.queued = rested_at();
  return work;
}

// A moving frame is always wanted: were it abandoned too, a viewer that moves faster than frames render would see none.
bool ViewerStream::wanted(const Work& work) const {
  return in_render(work) && (work.quality_stage == moving_stage || !(moved_ || runs()));
}

bool ViewerStream::yield(const Work& work) {
  if (!in_render(work)) return false;
  yielded_ = wanted(work);
  if (!yielded_) abandon();
  return yielded_;
}

bool ViewerStream::moves(Time now) const {
  constexpr auto lately = std::chrono::milliseconds(500);  // tuned: a pause in a movement is no reason for finer detail
  return runs() || now - moved_at_ < lately;
}

bool ViewerStream::rendered(const Work& work, double render_ms, double turn_ms, Time now) {
  if (!in_render(work)) return false;
  const RenderQuality& quality = work.request.quality;
  if (work.quality_stage == moving_stage)
    detail_.rendered(moving_details.at(static_cast<std::size_t>(moving_detail_of(quality))), turn_ms);
  else
    accumulated_ = work.request.first_sample + quality.samples;
  flights_.rendered(work.frame_id, work.quality_stage == moving_stage, render_ms);
  render_ms_ = render_ms;
  rendered_at_ = now;
  forget_work();
  return true;
}

void ViewerStream::encoded(const Work& work, std::size_t bytes, double encode_ms, Time now) {
  flights_.encoded(work.frame_id, encode_ms, now);
  encode_ms_ = encode_ms;
  if (work.quality_stage != moving_stage)
    flown_.reset();
  else if (!flown_)
    flown_.emplace();
  meter_.add(bytes, now);
}

// The view that fails now would fail again at once: it waits for another.
bool ViewerStream::failed(const Work& work) {
  const bool rendering = in_render(work);
  if (!rendering && !flights_.failed(work.frame_id)) return false;
  if (rendering) forget_work();
  if (work.frame_id >= view_frame_id_) given_up_ = true;
  return true;
}

void ViewerStream::forget_work() {
  work_.reset();
  yielded_ = false;
}

// Some samples of the step may be in the renderer's average already, so that the average starts anew.
void ViewerStream::abandon() {
  forget_work();
  accumulated_ = 0;
}

}  // namespace cloudscape::stream
