// JSON to described values (core/fields.h) and back. The one reader of the program: files, HTTP bodies and stream
// messages.
//
// Errors are InvalidInput with the JSON pointer, the value and the range: "/medium/single_scattering_albedo is 1.2:
// must be within [0, 1]"; an unknown key names the nearest known one. Absent keys keep the default. Numbers must be
// finite.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/fields.h"
#include "core/frame.h"
#include "settings/json_text.h"

namespace cloudscape::settings {

namespace detail {

// The parts of a value that JSON writes as an array of fixed length.
inline std::array<double*, 2> components(glm::dvec2& value) { return {&value.x, &value.y}; }
inline std::array<double*, 3> components(glm::dvec3& value) { return {&value.x, &value.y, &value.z}; }
inline std::array<int*, 2> components(ImageSize& value) { return {&value.width, &value.height}; }
template <class T, std::size_t size>
std::array<T*, size> components(std::array<T, size>& value) {
  std::array<T*, size> parts;
  for (std::size_t i = 0; i < size; ++i) parts[i] = &value[i];
  return parts;
}
template <class T>
concept Components = requires(T& value) {
  components(value);
};

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;
template <class T>
constexpr bool is_vector = false;
template <class T>
constexpr bool is_vector<std::vector<T>> = true;

// Limits, narrowed to what an integral type can hold.
template <class T>
Limits whole_limits(const Limits& limits) {
  return {std::max(limits.min, static_cast<double>(std::numeric_limits<T>::min())),
          std::min(limits.max, static_cast<double>(std::numeric_limits<T>::max())), limits.power_of_two};
}

bool read_bool(const nlohmann::json& json, const std::string& pointer);
double read_number(const nlohmann::json& json, const std::string& pointer, const Limits& limits);
std::string read_string(const nlohmann::json& json, const std::string& pointer, const Limits& lengths);
std::size_t read_choice(const nlohmann::json& json, const std::string& pointer,
                        std::span<const std::string_view> choices);
void check_whole(const nlohmann::json& json, const std::string& pointer, const Limits& limits);
void check_object(const nlohmann::json& json, const std::string& pointer, std::span<const std::string_view> known);
void check_array(const nlohmann::json& json, const std::string& pointer, const Limits& sizes);

template <class T>
T read_whole(const nlohmann::json& json, const std::string& pointer, const Limits& limits) {
  check_whole(json, pointer, whole_limits<T>(limits));
  return json.is_number_float() ? static_cast<T>(json.get<double>()) : json.get<T>();
}

}  // namespace detail

// The names of a described type's fields.
template <Described T>
std::vector<std::string_view> field_names(const T& value = {}) {
  std::vector<std::string_view> names;
  T::fields(value, [&](std::string_view name, auto&&...) { names.push_back(name); });
  return names;
}

// Fills `value` with what stands at `pointer`. Throws InvalidInput; `value` may be half filled then.
template <class T>
void read(const nlohmann::json& json, T& value, const std::string& pointer, const Limits& limits = {});

template <Described T>
void read_object(const nlohmann::json& json, T& value, const std::string& pointer) {
  detail::check_object(json, pointer, field_names(value));
  T::fields(value, [&](std::string_view name, auto& member, const Limits& limits, std::string_view) {
    if (const auto entry = json.find(name); entry != json.end())
      read(*entry, member, pointer + "/" + std::string(name), limits);
  });
}

template <class T>
void read_components(const nlohmann::json& json, T& value, const std::string& pointer, const Limits& limits) {
  const auto parts = detail::components(value);
  detail::check_array(json, pointer, {double(parts.size()), double(parts.size())});
  for (std::size_t i = 0; i < parts.size(); ++i) read(json[i], *parts[i], pointer + "/" + std::to_string(i), limits);
}

template <class T>
void read_elements(const nlohmann::json& json, std::vector<T>& values, const std::string& pointer,
                   const Limits& limits) {
  detail::check_array(json, pointer, limits);
  values.assign(json.size(), T{});
  for (std::size_t i = 0; i < values.size(); ++i) read(json[i], values[i], pointer + "/" + std::to_string(i));
}

template <class T>
void read(const nlohmann::json& json, T& value, const std::string& pointer, const Limits& limits) {
  if constexpr (Described<T>)
    read_object(json, value, pointer);
  else if constexpr (std::is_same_v<T, bool>)
    value = detail::read_bool(json, pointer);
  else if constexpr (std::is_enum_v<T>)
    value = static_cast<T>(detail::read_choice(json, pointer, EnumNames<T>::names));
  else if constexpr (std::is_integral_v<T>)
    value = detail::read_whole<T>(json, pointer, limits);
  else if constexpr (std::is_floating_point_v<T>)
    value = static_cast<T>(detail::read_number(json, pointer, limits));
  else if constexpr (detail::Components<T>)
    read_components(json, value, pointer, limits);
  else if constexpr (detail::is_vector<T>)
    read_elements(json, value, pointer, limits);
  else if constexpr (detail::is_optional<T>)
    json.is_null() ? value.reset() : read(json, value.emplace(), pointer, limits);
  else
    value = detail::read_string(json, pointer, limits);
}

// The JSON of a value, every field, in the order of the description.
template <class T>
nlohmann::ordered_json write(const T& value) {
  nlohmann::ordered_json json;
  if constexpr (Described<T>) {
    T::fields(value,
              [&](std::string_view name, const auto& member, auto&&...) { json[std::string(name)] = write(member); });
  } else if constexpr (std::is_enum_v<T>) {
    json = name_of(value);
  } else if constexpr (detail::Components<T>) {
    T copy = value;
    for (const auto* part : detail::components(copy)) json.push_back(write(*part));
  } else if constexpr (detail::is_vector<T>) {
    json = nlohmann::ordered_json::array();
    for (const auto& element : value) json.push_back(write(element));
  } else if constexpr (detail::is_optional<T>) {
    if (value) json = write(*value);
  } else {
    json = value;
  }
  return json;
}

}  // namespace cloudscape::settings
