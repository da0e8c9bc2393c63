// A sequence of frames along a camera path, as a person asks for it: by JSON body or on the command line.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/frame_container.h"
#include "settings/camera_path.h"
#include "settings/still_request.h"

namespace cloudscape::settings {

// Which frames: frame n is the path at n / frames_per_second seconds.
struct FrameRange {
  int first = 0;
  std::optional<int> last;  // nullopt: the path's last
  double frames_per_second = 30;

  static void fields(auto& self, auto&& visit) {
    visit("first", self.first, numbers, "Number of the first frame; frame n is the path at n / frames_per_second.");
    visit("last", self.last, numbers, "Number of the last frame; by default the path's.");
    visit("frames_per_second", self.frames_per_second, Limits{0.001, 1000}, "Frames for a second of the path's time.");
  }

 private:
  static constexpr Limits numbers{0, 9'999'999};
};

// "120-239" or "7" into `range`. Throws InvalidInput that names --frames.
void read_frames(const std::string& text, FrameRange& range);

struct SequenceRequest {
  StillRequest still;  // what all frames share
  CameraPath path;
  FrameRange range;  // with `last`
  ContainerKind container = ContainerKind::zip;

  int frames() const { return *range.last - range.first + 1; }
  // The path gives pose and field of view, and its time adds to the still's.
  FrameRequest frame(int number) const;
};

struct SequenceLimits {
  StillLimits still;  // each frame
  int max_frames = 1800;
  double max_gigasteps = 100000;  // of all frames
};

// Fills in the last frame. `where` is what errors call the frames: "--frames", "/frames". Throws InvalidInput: first
// after last, or last past the path's end.
SequenceRequest sequence_of(StillRequest still, CameraPath path, FrameRange range, const std::string& where);

// A still's body, of the camera only the lens without its field of view; and "path" (a name or a path's document),
// "frames" {first, last, frames_per_second}, "container". Throws InvalidInput, NotFound, OverLimit.
SequenceRequest sequence_from_json(std::string_view body, const CloudscapeLibrary& library,
                                   const SequenceLimits& limits);

}  // namespace cloudscape::settings
