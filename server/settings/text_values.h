// Described values as text: query parameters, environment variables and flags go through the same reader as JSON.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "settings/described_json.h"
#include "settings/described_schema.h"

namespace cloudscape::settings {

// What a parameter is, for help texts and the OpenAPI document. Lists of numbers or names are strings with commas.
struct ParameterInfo {
  std::string name;
  std::string type;  // number, integer, string, boolean
  std::string description;
  std::vector<std::string> values;  // where only some are allowed
  std::optional<double> min, max;
  std::string default_text;
};

ParameterInfo parameter_info(const std::string& name, const nlohmann::ordered_json& schema,
                             std::string_view description, const std::string& default_text);

// A value as text, as `read_text` takes it.
std::string value_as_text(const nlohmann::ordered_json& json);

namespace detail {
nlohmann::json json_of_number(const std::string& text);
nlohmann::json json_of_bool(const std::string& text);
std::vector<std::string> split(const std::string& text);

template <class T>
nlohmann::json json_of_text(const std::string& text) {
  if constexpr (std::is_same_v<T, bool>) {
    return json_of_bool(text);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return json_of_number(text);
  } else if constexpr (is_optional<T>) {
    return json_of_text<typename T::value_type>(text);
  } else if constexpr (is_vector<T>) {
    auto json = nlohmann::json::array();
    for (const std::string& part : split(text)) json.push_back(json_of_text<typename T::value_type>(part));
    return json;
  } else if constexpr (Components<T>) {
    auto json = nlohmann::json::array();
    for (const std::string& part : split(text)) json.push_back(json_of_number(part));
    return json;
  } else {
    return text;
  }
}
}  // namespace detail

// Fills `value` from text; errors as read's, `where` in place of the pointer.
template <class T>
void read_text(const std::string& text, T& value, const std::string& where, const Limits& limits) {
  read(detail::json_of_text<T>(text), value, where, limits);
}

template <class T>
ParameterInfo describe(const std::string& name, const T& value, const Limits& limits, std::string_view description) {
  return parameter_info(name, detail::schema_of(value, limits), description, value_as_text(write(value)));
}

}  // namespace cloudscape::settings
