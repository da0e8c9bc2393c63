// Numbers, booleans and lists in parameters, and what a schema says of them.
#include "settings/text_values.h"

#include <charconv>
#include <cmath>

namespace cloudscape::settings {

using nlohmann::json;
using nlohmann::ordered_json;

namespace detail {
namespace {

// The whole text as a number, or nothing.
template <class T>
std::optional<T> number_in(const std::string& text) {
  T number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

// What is no number stays text, so that the reader shows it in its message.
json json_of_number(const std::string& text) {
  if (const auto whole = number_in<std::int64_t>(text)) return *whole;
  if (const auto number = number_in<double>(text); number && std::isfinite(*number)) return *number;
  return text;
}

json json_of_bool(const std::string& text) {
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  if (trimmed(text).empty()) return parts;
  std::size_t start = 0;
  for (std::size_t comma; (comma = text.find(',', start)) != std::string::npos; start = comma + 1)
    parts.push_back(trimmed(text.substr(start, comma - start)));
  parts.push_back(trimmed(text.substr(start)));
  return parts;
}

}  // namespace detail

ParameterInfo parameter_info(const std::string& name, const ordered_json& schema, std::string_view description,
                             const std::string& default_text) {
  ParameterInfo info{name, "", std::string(description), {}, {}, {}, default_text};
  const ordered_json& type = schema["type"].is_array() ? schema["type"][0] : schema["type"];
  info.type = type == "array" ? "string" : type.get<std::string>();
  if (schema.contains("enum"))
    for (const auto& value : schema["enum"]) info.values.push_back(value_as_text(value));
  if (schema.contains("minimum")) info.min = schema["minimum"].get<double>();
  if (schema.contains("maximum")) info.max = schema["maximum"].get<double>();
  return info;
}

std::string value_as_text(const ordered_json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return number_text(value.get<double>());
  if (!value.is_array()) return to_text(value);
  std::string text;
  for (const auto& part : value) text += (text.empty() ? "" : ",") + value_as_text(part);
  return text;
}

}  // namespace cloudscape::settings
