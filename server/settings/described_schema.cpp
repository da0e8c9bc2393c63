// Schemas of single values, and the reference as Markdown that is read off a schema.
#include "settings/described_schema.h"

#include <cmath>

namespace cloudscape::settings {

using nlohmann::ordered_json;

namespace detail {
namespace {

ordered_json plain_number(double value) {
  return value == std::trunc(value) && std::abs(value) < 1e15 ? ordered_json(static_cast<long long>(value))
                                                              : ordered_json(value);
}

void set_bounds(ordered_json& schema, const Limits& limits, const char* min, const char* max) {
  if (std::isfinite(limits.min)) schema[min] = plain_number(limits.min);
  if (std::isfinite(limits.max)) schema[max] = plain_number(limits.max);
}

}  // namespace

ordered_json number_schema(bool whole, const Limits& limits) {
  ordered_json schema{{"type", whole ? "integer" : "number"}};
  set_bounds(schema, limits, "minimum", "maximum");
  if (limits.power_of_two)
    for (double power = std::exp2(std::ceil(std::log2(limits.min))); power <= limits.max; power *= 2)
      schema["enum"].push_back(plain_number(power));
  return schema;
}

ordered_json string_schema(const Limits& lengths) {
  ordered_json schema{{"type", "string"}};
  set_bounds(schema, lengths, "minLength", "maxLength");
  return schema;
}

ordered_json choice_schema(std::span<const std::string_view> choices) {
  return {{"type", "string"}, {"enum", choices}};
}

ordered_json without_defaults(ordered_json items) {
  if (items.contains("properties"))
    for (auto& property : items["properties"]) property.erase("default");
  return items;
}

ordered_json array_schema(ordered_json items, const Limits& sizes) {
  ordered_json schema{{"type", "array"}, {"items", std::move(items)}};
  set_bounds(schema, sizes, "minItems", "maxItems");
  return schema;
}

}  // namespace detail

namespace {

std::string interval(const ordered_json& property, const char* min, const char* max) {
  if (!property.contains(min) || !property.contains(max)) return "";
  return " in [" + number_text(property[min]) + ", " + number_text(property[max]) + "]";
}

std::string list_of(const ordered_json& values) {
  std::string text;
  for (const auto& value : values)
    text += (text.empty() ? "" : ", ") + (value.is_string() ? value.get<std::string>() : to_text(value));
  return text;
}

std::string array_text(const ordered_json& property) {
  const std::string items = value_text(property["items"]);
  if (!property.contains("maxItems")) return "array of " + items;
  const bool exact = property.value("minItems", 0) == property["maxItems"];
  return "array of " + std::string(exact ? "" : "at most ") + to_text(property["maxItems"]) + ": each " + items;
}

std::string default_of(const ordered_json& property) {
  return property.contains("default") ? to_text(property["default"]) : "";
}

// Too long for a table's cell.
bool is_long(const std::string& text) { return text.size() > 60; }

// One line of a Markdown table.
std::string row(const std::string& key, const ordered_json& property) {
  const std::string fallback = default_of(property);
  return "| `" + key + "` | " + value_text(property) + " | " +
         (fallback.empty()    ? ""
          : is_long(fallback) ? "see below"
                              : "`" + fallback + "`") +
         " | " + property.value("description", "") + " |\n";
}

// A list, one element a line.
std::string lines_of(const ordered_json& list) {
  std::string text;
  for (const auto& element : list) text += (text.empty() ? "[" : ",\n ") + to_text(element);
  return text + "]\n";
}

// The object inside a property (itself, or an array's items), or nullptr.
const ordered_json* object_in(const ordered_json& property) {
  if (property.contains("properties")) return &property;
  if (property.contains("items")) return object_in(property["items"]);
  return nullptr;
}

}  // namespace

std::string value_text(const ordered_json& property) {
  const ordered_json& type = property["type"];
  if (type.is_array()) {
    ordered_json without_null = property;
    without_null["type"] = type[0];
    return value_text(without_null) + " or null";
  }
  if (property.contains("enum")) return "one of " + list_of(property["enum"]);
  if (type == "array") return array_text(property);
  if (type == "string")
    return "string" +
           (property.contains("maxLength") ? ", at most " + to_text(property["maxLength"]) + " characters" : "");
  return type.get<std::string>() + interval(property, "minimum", "maximum");
}

std::string reference(const ordered_json& schema, const std::string& title) {
  std::string text = "### " + title + "\n\n";
  if (schema.contains("description")) text += schema["description"].get<std::string>() + "\n\n";
  text += "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const auto& [key, property] : schema["properties"].items()) text += row(key, property);
  for (const auto& [key, property] : schema["properties"].items())
    if (is_long(default_of(property)))
      text += "\nDefault of `" + key + "`:\n\n```json\n" + lines_of(property["default"]) + "```\n";
  for (const auto& [key, property] : schema["properties"].items())
    if (const ordered_json* object = object_in(property))
      text += "\n" + reference(*object, (schema.contains("$id") ? "" : title + ".") + key);
  return text;
}

}  // namespace cloudscape::settings
