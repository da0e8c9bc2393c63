// What the server says beside frames: values to JSON text and back.
#include "settings/described_json.h"
#include "wire/messages.h"

namespace cloudscape::wire {
namespace {

constexpr std::array<std::string_view, 4> types{"welcome", "stats", "error", "clock"};  // as ServerMessage has them

template <class T>
T read_message(const nlohmann::json& message) {
  T value;
  settings::read(message, value, "");
  return value;
}

}  // namespace

std::string to_text(const ServerMessage& message) {
  nlohmann::ordered_json json{{"type", types[message.index()]}};
  std::visit([&](const auto& value) { json.update(settings::write(value)); }, message);
  return settings::to_text(json);
}

ServerMessage parse_server_message(std::string_view text) {
  nlohmann::json message = settings::parse_json(text, "the message");
  if (!message.is_object()) settings::refuse("", message, "an object");
  const auto type = message.find("type");
  if (type == message.end()) throw InvalidInput("/type", "is missing");
  const std::size_t index = settings::detail::read_choice(*type, "/type", types);
  message.erase(type);
  if (index == 0) return read_message<Welcome>(message);
  if (index == 1) return read_message<Stats>(message);
  if (index == 2) return read_message<ErrorMessage>(message);
  return read_message<ClockState>(message);
}

}  // namespace cloudscape::wire
