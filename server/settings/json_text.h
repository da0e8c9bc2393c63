// JSON as text: parsing with positions, and values as people should see them in messages and on the command line.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/fields.h"

namespace cloudscape::settings {

// Parses JSON, with // and /* */ comments. Throws InvalidInput that names line and column; for a key that stands twice
// and for nesting deeper than 32 too.
nlohmann::json parse_json(std::string_view text, const std::string& source);

// JSON text; bytes that are not UTF-8 become U+FFFD. `indent` as nlohmann's: -1 is one line.
std::string to_text(const nlohmann::ordered_json& json, int indent = -1);

// The shortest decimal that reads back as the same double; whole numbers without exponent. -0 is 0.
std::string number_text(double value);
// "within [0, 1]", "a power of two within [16, 512]", "at least 0", "1".
std::string range_text(const Limits& limits);
// A value in a message: one line of ASCII, cut off after 60 characters.
std::string shown(const nlohmann::json& value);
// A part of a JSON pointer (RFC 6901), one line of ASCII, cut off after 60 characters.
std::string pointer_part(std::string_view name);

// The known name that is most likely meant, if any is near.
std::optional<std::string_view> nearest(std::string_view name, std::span<const std::string_view> known);
// "did you mean extinction_per_m?", or the list of what is known.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

// Throws InvalidInput "POINTER is VALUE: must be MUST".
[[noreturn]] void refuse(const std::string& pointer, const nlohmann::json& value, const std::string& must);

}  // namespace cloudscape::settings
