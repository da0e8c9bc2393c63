// The stream protocol cloudscape.v1: messages of both directions as values, and as bytes.
//
// The client sends JSON text: hello (once, first), camera, settings, clock, ack. The server sends JSON text (welcome,
// clock, stats, error) and one binary message a frame: FrameHeader, then the image.
//
// A document that has a name has one clock, which is shared: every stream of it shows its time, and a `clock` from any
// of them turns it for all. The server tells each of them what it shows, after the welcome and after each change. A
// document of the client's own has a clock of its own. A stream that gives a `time_s` (in hello, settings or camera)
// has that time for itself, until it sends a `clock` or a settings with "time_s": null.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/clock.h"
#include "core/frame.h"

namespace cloudscape::wire {

constexpr std::string_view subprotocol = "cloudscape.v1";
constexpr std::size_t max_client_message_bytes = 64 * 1024;  // a hello may carry a whole document

// {"type":"hello","version":1,"cloudscape":"fair-weather-cumulus","size_px":[1280,720],...} and, as settings, any of
// its members later. Absent members keep their value, those inside pose, lens, display and march too; in hello they
// start from the document's `view`.
struct Settings {
  std::optional<std::string> cloudscape;           // name; or
  std::optional<std::string> cloudscape_document;  // the JSON text of a whole document ("cloudscape": {...})
  std::optional<ImageSize> size_px;                // "size_px": [width, height]
  std::optional<CameraPose> pose;                  // "pose": {...}
  std::optional<Lens> lens;
  std::optional<Display> display;
  std::optional<March> march;
  std::optional<Quality> quality;         // "quality": "standard"
  std::optional<double> sun_azimuth_deg;  // null resets to the document's
  std::optional<double> sun_elevation_deg;
  bool reset_sun = false;               // either of the two was null
  std::optional<double> sun_time_rate;  // of the document's place, which must have a time
  std::optional<double> time_s;
  bool follow_clock = false;  // "time_s": null
};
struct Hello {
  int version = 1;
  Settings settings;
};
// {"type":"camera","pose_sequence":7,"pose":{"position_m":[0,0,2],"azimuth_deg":0,"elevation_deg":10,"roll_deg":0},"time_s":0}
struct Camera {
  std::uint64_t pose_sequence = 0;
  CameraPose pose;
  std::optional<double> time_s;
};
// {"type":"ack","frame_id":12,"decode_ms":3.1}, after the frame is on display.
struct Ack {
  std::uint32_t frame_id = 0;
  double decode_ms = 0;
};
// {"type":"clock","time_s":600,"rate":10,"paused":false}: ClockChange.
using ClientMessage = std::variant<Hello, Settings, Camera, Ack, ClockChange>;

// `current` is what a pose, lens or display that is given in part is completed from: what the stream shows, or for a
// hello the document's `view`. Throws InvalidInput with a JSON pointer: not JSON, unknown type or key, wrong type, out
// of range, not finite.
ClientMessage parse_client_message(std::string_view text, const View& current = {});
std::string to_text(const ClientMessage& message);  // what the native viewer sends

struct Welcome {
  std::string program_version, renderer;
  bool software = false;
  std::string cloudscape;  // "" for a document of the client's own
  CameraPose pose;         // that the stream starts from
  Lens lens;
  Display display;
  double sun_azimuth_deg = 0, sun_elevation_deg = 0;
  ImageSize size_px, max_size_px;
  std::string time_utc;
  double sun_time_rate = 0;

  static void fields(auto& self, auto&& visit) {
    visit("program_version", self.program_version, Limits{}, "Version of the server.");
    visit("renderer", self.renderer, Limits{}, "Name of what renders.");
    visit("software", self.software, Limits{}, "Whether it renders without a GPU.");
    visit("cloudscape", self.cloudscape, Limits{}, "Name; empty for a document of the client's own.");
    visit("pose", self.pose, Limits{}, "Pose that the stream starts from.");
    visit("lens", self.lens, Limits{}, "Lens that the stream starts from.");
    visit("display", self.display, Limits{}, "Display that the stream starts from.");
    visit("sun_azimuth_deg", self.sun_azimuth_deg, Limits{}, "Where the sun stands, clockwise from north, degrees.");
    visit("sun_elevation_deg", self.sun_elevation_deg, Limits{}, "Height of the sun above the horizon, degrees.");
    visit("size_px", self.size_px, Limits{}, "Size of the frames.");
    visit("max_size_px", self.max_size_px, Limits{}, "Largest sides that the server takes.");
    visit("time_utc", self.time_utc, Limits{}, "When time_s is 0; empty: the sun stands where it is put.");
    visit("sun_time_rate", self.sun_time_rate, Limits{}, "How fast the sun's time runs beside time_s.");
  }
};
struct Stats {
  double frames_per_second = 0, bits_per_second = 0, round_trip_ms = 0, render_ms = 0, encode_ms = 0;
  std::uint64_t frames_dropped = 0;
  int window = 1;

  static void fields(auto& self, auto&& visit) {
    visit("frames_per_second", self.frames_per_second, Limits{}, "Frames that were sent, 1/s.");
    visit("bits_per_second", self.bits_per_second, Limits{}, "Bits that were sent, 1/s.");
    visit("round_trip_ms", self.round_trip_ms, Limits{}, "From sending a frame to its acknowledgement, ms.");
    visit("render_ms", self.render_ms, Limits{}, "Time to render a frame, ms.");
    visit("encode_ms", self.encode_ms, Limits{}, "Time to encode a frame, ms.");
    visit("frames_dropped", self.frames_dropped, Limits{}, "Frames that newer ones replaced.");
    visit("window", self.window, Limits{}, "Frames that may wait for their acknowledgement.");
  }
};
struct ErrorMessage {
  std::string message, pointer;
  bool fatal = false;  // the server closes after it

  static void fields(auto& self, auto&& visit) {
    visit("message", self.message, Limits{}, "One sentence: what, where, the remedy.");
    visit("pointer", self.pointer, Limits{}, "JSON pointer into the client's message.");
    visit("fatal", self.fatal, Limits{}, "Whether the server closes the stream.");
  }
};
using ServerMessage = std::variant<Welcome, Stats, ErrorMessage, ClockState>;
std::string to_text(const ServerMessage& message);  // valid JSON whatever bytes the strings hold
ServerMessage parse_server_message(std::string_view text);

// Little-endian, packed in this order without gaps; `frame_header_bytes` long.
struct FrameHeader {
  std::uint8_t version = 1;
  std::uint8_t quality_stage = 0;  // 0 moving, 1.. refining, 255 final
  std::uint8_t image_format = 0;   // ImageFormat
  std::uint8_t lens_kind = 0;      // LensKind
  std::uint32_t frame_id = 0;
  std::uint64_t pose_sequence = 0;
  std::uint16_t width_px = 0, height_px = 0;
  float vertical_fov_deg = 0;
  double position_m[3] = {0, 0, 0};
  double azimuth_deg = 0, elevation_deg = 0, roll_deg = 0;
  double time_s = 0;
  float render_ms = 0, encode_ms = 0;
  std::uint32_t image_bytes = 0;
  bool operator==(const FrameHeader&) const = default;
};
constexpr std::size_t frame_header_bytes = 1 * 4 + 4 + 8 + 2 * 2 + 4 + 7 * 8 + 2 * 4 + 4;  // 92

FrameHeader frame_header(const Frame& frame, std::uint32_t frame_id, std::uint64_t pose_sequence,
                         std::uint8_t quality_stage, double encode_ms, std::size_t image_bytes);
void write(const FrameHeader& header, std::span<std::uint8_t, frame_header_bytes> out);
// Throws Error if the message is too short, of another version, names no format or lens, holds a number that is not
// finite, or its length is not that of header and image.
FrameHeader read_frame_header(std::span<const std::uint8_t> message);

}  // namespace cloudscape::wire
