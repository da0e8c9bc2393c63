// JSON Schema 2020-12 and a Markdown reference of described types.
#pragma once
#include <string>

#include "settings/described_json.h"

namespace cloudscape::settings {

namespace detail {

nlohmann::ordered_json number_schema(bool whole, const Limits& limits);
nlohmann::ordered_json string_schema(const Limits& lengths);
nlohmann::ordered_json choice_schema(std::span<const std::string_view> choices);
// Places of a fixed array have defaults of their own, which the array's default gives.
nlohmann::ordered_json without_defaults(nlohmann::ordered_json items);
nlohmann::ordered_json array_schema(nlohmann::ordered_json items, const Limits& sizes);

// `sample` carries the defaults of what is inside.
template <class T>
nlohmann::ordered_json schema_of(const T& sample, const Limits& limits = {}) {
  if constexpr (Described<T>) {
    nlohmann::ordered_json properties;
    T::fields(sample, [&](std::string_view name, const auto& member, const Limits& within, std::string_view meaning) {
      auto& property = properties[std::string(name)] = {{"description", meaning}};
      property.update(schema_of(member, within));
      if constexpr (!Described<std::remove_cvref_t<decltype(member)>>) property["default"] = write(member);
    });
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  } else if constexpr (std::is_same_v<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_enum_v<T>) {
    return choice_schema(EnumNames<T>::names);
  } else if constexpr (std::is_integral_v<T>) {
    return number_schema(true, whole_limits<T>(limits));
  } else if constexpr (std::is_floating_point_v<T>) {
    return number_schema(false, limits);
  } else if constexpr (Components<T>) {
    T copy = sample;
    const auto parts = components(copy);
    return array_schema(without_defaults(schema_of(*parts[0], limits)), {double(parts.size()), double(parts.size())});
  } else if constexpr (is_vector<T>) {
    return array_schema(schema_of(typename T::value_type{}), limits);
  } else if constexpr (is_optional<T>) {
    auto schema = schema_of(sample.value_or(typename T::value_type{}), limits);
    schema["type"] = {schema["type"], "null"};
    return schema;
  } else {
    return string_schema(limits);
  }
}

}  // namespace detail

template <Described T>
nlohmann::ordered_json schema(const std::string& id, const std::string& title) {
  nlohmann::ordered_json json{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"$id", id}, {"title", title}};
  json.update(detail::schema_of(T{}));
  return json;
}

// Tables (key, value, default, meaning) of an object's schema, one for each object in it, headings `### title`.
std::string reference(const nlohmann::ordered_json& schema, const std::string& title);
// What a property may be: "number in [0, 1]", "one of none, uniform, clear", ...
std::string value_text(const nlohmann::ordered_json& property);

}  // namespace cloudscape::settings
