#include "settings/sequence_request.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "settings/described_json.h"
#include "settings/still_reader.h"

namespace cloudscape::settings {
namespace {

using nlohmann::json;

// The error of a value that stands at `pointer` inside the body.
InvalidInput moved(const InvalidInput& error, const std::string& pointer) {
  const std::string sentence = error.what();
  return {pointer + error.pointer, error.pointer.empty() ? sentence : sentence.substr(error.pointer.size() + 1)};
}

CameraPath path_in(const json& body) {
  const auto path = body.find("path");
  if (path == body.end()) throw InvalidInput("/path", "is missing: must name a path, such as fly-around, or be one");
  if (path->is_string()) return named_camera_path(path->get_ref<const std::string&>());
  if (!path->is_object()) refuse("/path", *path, "a path's name or a whole path");
  try {
    return parse_camera_path(path->dump(), "/path");
  } catch (const InvalidInput& error) {
    throw moved(error, "/path");
  }
}

// What the path says cannot be said again.
void check_camera(const json& body) {
  const auto camera = body.find("camera");
  if (camera == body.end()) return;
  constexpr std::array<std::string_view, 1> lens_only{"lens"};
  constexpr std::array<std::string_view, 2> but_field_of_view{"kind", "width_m"};
  detail::check_object(*camera, "/camera", lens_only);
  if (const auto lens = camera->find("lens"); lens != camera->end())
    detail::check_object(*lens, "/camera/lens", but_field_of_view);
}

void check_limits(const SequenceRequest& sequence, const SequenceLimits& limits) {
  if (sequence.frames() > limits.max_frames)
    throw OverLimit("/frames", "are " + std::to_string(sequence.frames()) + ": this server's limit is " +
                                   std::to_string(limits.max_frames));
  const FrameRequest& frame = sequence.still.frame;
  const double gigasteps = gigasteps_of(frame) * sequence.frames();
  if (gigasteps > limits.max_gigasteps)
    throw OverLimit("/frames", "ask for " + number_text(std::round(gigasteps)) +
                                   " gigasteps (frames * pixels * samples * steps * (1 + light steps) / 1e9): this "
                                   "server's limit is " +
                                   number_text(limits.max_gigasteps) +
                                   " (max_job_gigasteps); ask for fewer frames, or lower width, height, samples, "
                                   "quality, max_steps or light_steps");
}

}  // namespace

void read_frames(const std::string& text, FrameRange& range) {
  const auto number = [&](const std::string& digits) {
    constexpr std::size_t most_digits = 7;
    if (digits.empty() || digits.size() > most_digits || digits.find_first_not_of("0123456789") != std::string::npos)
      throw InvalidInput("--frames", "is '" + text + "': must be FIRST-LAST, such as 0-299");
    return std::stoi(digits);
  };
  const std::size_t dash = std::min(text.find('-'), text.size());
  range.first = number(text.substr(0, dash));
  range.last = dash == text.size() ? range.first : number(text.substr(dash + 1));
}

SequenceRequest sequence_of(StillRequest still, CameraPath path, FrameRange range, const std::string& where) {
  const double fps = range.frames_per_second, end_s = path.keys.back().time_s;
  constexpr double rounding = 1e-6;  // frames; 0.7 s at 10 frames a second are 7 frames
  const double last_of_path = std::floor(end_s * fps + rounding);
  if (last_of_path < 0) throw InvalidInput(where, "cannot be had of a path that ends before second 0");
  if (!range.last) range.last = static_cast<int>(std::min(last_of_path, 9'999'999.0));
  const std::string frames = std::to_string(range.first) + "-" + std::to_string(*range.last);
  if (*range.last > last_of_path)
    throw InvalidInput(where, "are " + frames + ", but the path's " + number_text(end_s) + " s end with frame " +
                                  number_text(last_of_path) + " at " + number_text(fps) + " frames a second");
  if (range.first > *range.last) throw InvalidInput(where, "are " + frames + ": the last must not be before the first");
  return {std::move(still), std::move(path), range, ContainerKind::zip};
}

FrameRequest SequenceRequest::frame(int number) const {
  const double time_s = number / range.frames_per_second;
  const CameraPath::Key key = key_at(path, time_s);
  FrameRequest request = still.frame;
  request.pose = key.pose;
  request.lens.vertical_fov_deg = key.vertical_fov_deg;
  request.time_s += time_s;
  return request;
}

SequenceRequest sequence_from_json(std::string_view text, const CloudscapeLibrary& library,
                                   const SequenceLimits& limits) {
  json body = parse_json(text, "body");
  if (!body.is_object()) refuse("", body, "an object");
  check_camera(body);
  CameraPath path = path_in(body);
  FrameRange range;
  ContainerKind container = ContainerKind::zip;
  if (const auto frames = body.find("frames"); frames != body.end()) read(*frames, range, "/frames");
  if (const auto kind = body.find("container"); kind != body.end()) read(*kind, container, "/container");
  for (const char* own : {"path", "frames", "container"}) body.erase(own);
  StillRequest still = still_from_parsed(std::move(body), library, limits.still);
  if (container == ContainerKind::avi && still.encoding.format != ImageFormat::jpeg)
    throw InvalidInput("/container", "is \"avi\", which holds JPEG frames: must be \"zip\" for this /image/format");
  SequenceRequest sequence = sequence_of(std::move(still), std::move(path), range, "/frames");
  sequence.container = container;
  check_limits(sequence, limits);
  return sequence;
}

}  // namespace cloudscape::settings
