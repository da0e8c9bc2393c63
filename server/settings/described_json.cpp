// The parts of the described reader that do not depend on the type: one value, checked.
#include "settings/described_json.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::settings::detail {
namespace {

using nlohmann::json;

bool within(double value, const Limits& limits) { return value >= limits.min && value <= limits.max; }

bool is_power_of_two(double value) {
  int exponent = 0;
  return value > 0 && std::frexp(value, &exponent) == 0.5;
}

// "has 97 characters: must have at most 80".
void check_count(std::size_t count, const std::string& pointer, const Limits& limits, const std::string& unit) {
  if (within(static_cast<double>(count), limits)) return;
  const bool exact = limits.min == limits.max, few = static_cast<double>(count) < limits.min;
  throw InvalidInput(pointer, "has " + std::to_string(count) + " " + unit + ": must have " +
                                  (exact ? ""
                                   : few ? "at least "
                                         : "at most ") +
                                  number_text(few ? limits.min : limits.max));
}

std::string list_of(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace

bool read_bool(const json& value, const std::string& pointer) {
  if (!value.is_boolean()) refuse(pointer, value, "true or false");
  return value.get<bool>();
}

double read_number(const json& value, const std::string& pointer, const Limits& limits) {
  if (!value.is_number()) refuse(pointer, value, "a number");
  const double number = value.get<double>();
  if (!std::isfinite(number)) refuse(pointer, value, "finite");
  if (!within(number, limits)) refuse(pointer, value, range_text(limits));
  return number + 0.0;  // -0 is 0, so that equal values are written equally
}

void check_whole(const json& value, const std::string& pointer, const Limits& limits) {
  if (!value.is_number()) refuse(pointer, value, "a whole number");
  constexpr double exact_integers = 9007199254740992.0;  // 2^53
  const double number = value.get<double>();
  const bool whole = !value.is_number_float() || (std::abs(number) <= exact_integers && number == std::trunc(number));
  if (!whole) refuse(pointer, value, "a whole number " + range_text(limits));
  if (!within(number, limits) || (limits.power_of_two && !is_power_of_two(number)))
    refuse(pointer, value, range_text(limits));
}

std::string read_string(const json& value, const std::string& pointer, const Limits& lengths) {
  if (!value.is_string()) refuse(pointer, value, "a string");
  const std::string text = value.get<std::string>();
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };  // UTF-8
  const auto extra_bytes = std::count_if(text.begin(), text.end(), continues);
  check_count(text.size() - static_cast<std::size_t>(extra_bytes), pointer, lengths, "characters");
  return text;
}

std::size_t read_choice(const json& value, const std::string& pointer, std::span<const std::string_view> choices) {
  if (value.is_string()) {
    const auto choice = std::find(choices.begin(), choices.end(), value.get_ref<const std::string&>());
    if (choice != choices.end()) return static_cast<std::size_t>(choice - choices.begin());
  }
  refuse(pointer, value, "one of " + list_of(choices));
}

void check_object(const json& value, const std::string& pointer, std::span<const std::string_view> known) {
  if (!value.is_object()) refuse(pointer, value, "an object");
  for (const auto& entry : value.items())
    if (std::find(known.begin(), known.end(), entry.key()) == known.end())
      throw InvalidInput(pointer + "/" + pointer_part(entry.key()),
                         "is not a known key: " + suggestion(entry.key(), known));
}

void check_array(const json& value, const std::string& pointer, const Limits& sizes) {
  if (!value.is_array()) refuse(pointer, value, "an array");
  check_count(value.size(), pointer, sizes, "elements");
}

}  // namespace cloudscape::settings::detail
