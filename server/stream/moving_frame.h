// What a view is answered with: the same for the scheduler and for benchmarks that judge a moving stream's pictures.
#pragma once
#include "stream/frame_scheduler.h"
#include "stream/quality_control.h"

namespace cloudscape::stream {

inline FrameRequest request_of(const StreamView& view, StreamId stream, std::uint64_t sequence) {
  FrameRequest request;
  request.cloudscape = view.cloudscape;
  request.pose = view.pose;
  request.lens = view.lens;
  request.display = view.display;
  request.march = view.march;
  request.size_px = view.size_px;
  request.time_s = view.time_s;
  request.stream = stream;
  request.sequence = sequence;
  return request;
}

// While the view changes from frame to frame.
inline FrameRequest moving_request(const StreamView& view, StreamId stream, std::uint64_t sequence,
                                   const MovingDetail& detail) {
  FrameRequest request = request_of(view, stream, sequence);
  request.quality = moving_quality(detail);
  request.light_may_lag = true;
  return request;
}

}  // namespace cloudscape::stream
