// What the client says: JSON text to values and back.
#include "settings/cloudscape_reader.h"
#include "settings/described_json.h"
#include "settings/still_body.h"
#include "wire/messages.h"

namespace cloudscape::wire {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

// The members of hello and settings, all of them, as the message completes them from the present view.
struct SettingsBody {
  ImageSize size_px;
  View view;
  Quality quality = Quality::standard;
  Sun sun;
  double sun_time_rate = 0;
  double time_s = 0;

  static void fields(auto& self, auto&& visit) {
    visit("size_px", self.size_px, settings::side_px_limits, "Width and height of the frames, pixels.");
    View::fields(self.view, visit);
    visit("quality", self.quality, Limits{}, "What a resting view is refined to; reference: as finest.");
    settings::StillSun::each_angle(self.sun, [&](std::string_view, auto& angle, const Limits& limits, auto meaning) {
      visit(&angle == &self.sun.azimuth_deg ? "sun_azimuth_deg" : "sun_elevation_deg", angle, limits, meaning);
    });
    visit("sun_time_rate", self.sun_time_rate, clock_rate_limits, "How fast the sun's time runs beside time_s.");
    visit("time_s", self.time_s, time_s_limits, "Time that the wind has moved the clouds for, s.");
  }
};

struct CameraBody {
  Camera camera;
  double time_s = 0;

  static void fields(auto& self, auto&& visit) {
    visit("pose_sequence", self.camera.pose_sequence, Limits{}, "Comes back with the frames of this pose.");
    visit("pose", self.camera.pose, Limits{}, "Where the camera is and looks.");
    visit("time_s", self.time_s, time_s_limits, "Time that the wind has moved the clouds for, s.");
  }
};

struct AckBody {
  Ack ack;

  static void fields(auto& self, auto&& visit) {
    visit("frame_id", self.ack.frame_id, Limits{}, "Of the frame that is on display.");
    visit("decode_ms", self.ack.decode_ms, Limits{0, 1e7}, "Time to decode it, ms.");
  }
};

void require(const json& message, const std::string& key) {
  if (!message.contains(key)) throw InvalidInput("/" + key, "is missing");
}

// Takes a member out of the message that the described reader does not know.
std::optional<json> take(json& message, const char* key) {
  const auto found = message.find(key);
  if (found == message.end()) return std::nullopt;
  std::optional<json> value = std::move(*found);
  message.erase(found);
  return value;
}

void take_cloudscape(json& message, Settings& settings) {
  const auto cloudscape = take(message, "cloudscape");
  if (!cloudscape) return;
  if (cloudscape->is_string()) {
    settings::read(*cloudscape, settings.cloudscape.emplace(), "/cloudscape", {1, 64});
  } else if (cloudscape->is_object()) {
    settings::read_cloudscape(*cloudscape, "/cloudscape");
    settings.cloudscape_document = cloudscape->dump();
  } else {
    settings::refuse("/cloudscape", *cloudscape, "a cloudscape's name or a whole document");
  }
}

void take_sun_reset(json& message, Settings& settings) {
  for (const char* key : {"sun_azimuth_deg", "sun_elevation_deg"}) {
    const auto angle = message.find(key);
    if (angle == message.end() || !angle->is_null()) continue;
    settings.reset_sun = true;
    message.erase(angle);
  }
}

void take_clock(json& message, Settings& settings) {
  const auto time = message.find("time_s");
  if (time == message.end() || !time->is_null()) return;
  settings.follow_clock = true;
  message.erase(time);
}

Settings read_settings(json message, const View& current) {
  Settings settings;
  take_clock(message, settings);
  take_cloudscape(message, settings);
  take_sun_reset(message, settings);
  SettingsBody body;
  body.view = current;
  auto known = settings::field_names(body);
  known.push_back("cloudscape");
  settings::detail::check_object(message, "", known);
  settings::read(message, body, "");
  const auto keep = [&](const char* key, const auto& value, auto& member) {
    if (message.contains(key)) member = value;
  };
  keep("size_px", body.size_px, settings.size_px);
  keep("pose", body.view.pose, settings.pose);
  keep("lens", body.view.lens, settings.lens);
  keep("display", body.view.display, settings.display);
  keep("march", body.view.march, settings.march);
  keep("quality", body.quality, settings.quality);
  keep("sun_azimuth_deg", body.sun.azimuth_deg, settings.sun_azimuth_deg);
  keep("sun_elevation_deg", body.sun.elevation_deg, settings.sun_elevation_deg);
  keep("sun_time_rate", body.sun_time_rate, settings.sun_time_rate);
  keep("time_s", body.time_s, settings.time_s);
  return settings;
}

Hello read_hello(json message, const View& current) {
  Hello hello;
  if (const auto version = take(message, "version")) settings::read(*version, hello.version, "/version", {1, 1});
  hello.settings = read_settings(std::move(message), current);
  return hello;
}

Camera read_camera(const json& message, const View& current) {
  CameraBody body;
  body.camera.pose = current.pose;
  settings::read(message, body, "");
  require(message, "pose");
  if (message.contains("time_s")) body.camera.time_s = body.time_s;
  return body.camera;
}

Ack read_ack(const json& message) {
  AckBody body;
  settings::read(message, body, "");
  require(message, "frame_id");
  return body.ack;
}

ClockChange read_clock(const json& message) {
  ClockState told;
  settings::read(message, told, "");
  ClockChange change;
  if (message.contains("time_s")) change.time_s = told.time_s;
  if (message.contains("rate")) change.rate = told.rate;
  if (message.contains("paused")) change.paused = told.paused;
  return change;
}

ordered_json json_of(const Settings& settings) {
  ordered_json message = ordered_json::object();
  const auto add = [&](const char* key, const auto& member) {
    if (member) message[key] = settings::write(*member);
  };
  add("cloudscape", settings.cloudscape);
  if (settings.cloudscape_document)
    message["cloudscape"] = settings::parse_json(*settings.cloudscape_document, "the document");
  add("size_px", settings.size_px);
  add("pose", settings.pose);
  add("lens", settings.lens);
  add("display", settings.display);
  add("march", settings.march);
  add("quality", settings.quality);
  if (settings.reset_sun) message["sun_azimuth_deg"] = message["sun_elevation_deg"] = nullptr;
  add("sun_azimuth_deg", settings.sun_azimuth_deg);
  add("sun_elevation_deg", settings.sun_elevation_deg);
  add("sun_time_rate", settings.sun_time_rate);
  if (settings.follow_clock) message["time_s"] = nullptr;
  add("time_s", settings.time_s);
  return message;
}

ordered_json json_of(const Hello& hello) {
  ordered_json message{{"version", hello.version}};
  message.update(json_of(hello.settings));
  return message;
}

ordered_json json_of(const Camera& camera) {
  ordered_json message{{"pose_sequence", camera.pose_sequence}, {"pose", settings::write(camera.pose)}};
  if (camera.time_s) message["time_s"] = *camera.time_s;
  return message;
}

ordered_json json_of(const Ack& ack) { return settings::write(AckBody{ack}); }

ordered_json json_of(const ClockChange& change) {
  ordered_json message = ordered_json::object();
  if (change.time_s) message["time_s"] = *change.time_s;
  if (change.rate) message["rate"] = *change.rate;
  if (change.paused) message["paused"] = *change.paused;
  return message;
}

constexpr std::array<std::string_view, 5> types{"hello", "settings", "camera", "ack", "clock"};  // as ClientMessage's
enum class Type { hello, settings, camera, ack, clock };

}  // namespace

ClientMessage parse_client_message(std::string_view text, const View& current) {
  if (text.size() > max_client_message_bytes)
    throw InvalidInput("", "the message has " + std::to_string(text.size()) + " bytes: must have at most " +
                               std::to_string(max_client_message_bytes));
  json message = settings::parse_json(text, "the message");
  if (!message.is_object()) settings::refuse("", message, "an object");
  require(message, "type");
  const auto type = settings::detail::read_choice(*take(message, "type"), "/type", types);
  switch (static_cast<Type>(type)) {
    case Type::hello:
      return read_hello(std::move(message), current);
    case Type::settings:
      return read_settings(std::move(message), current);
    case Type::camera:
      return read_camera(message, current);
    case Type::ack:
      return read_ack(message);
    case Type::clock:
      return read_clock(message);
  }
  throw InvalidInput("/type", "is unknown");
}

std::string to_text(const ClientMessage& message) {
  ordered_json json{{"type", types[message.index()]}};
  std::visit([&](const auto& value) { json.update(json_of(value)); }, message);
  return settings::to_text(json);
}

}  // namespace cloudscape::wire
