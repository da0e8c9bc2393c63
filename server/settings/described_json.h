// JSON to described values (core/fields.h) and back. The one reader of the program: files, HTTP bodies and stream
// messages.
//
// Errors are InvalidInput with the JSON pointer, the value and the range: "/medium/single_scattering_albedo is 1.2:
// must be within [0, 1]"; an unknown key names the nearest known one. Absent keys keep the default. Numbers must be
// finite.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/fields.h"

namespace cloudscape::settings {

// Parses JSON, with // and /* */ comments. Throws InvalidInput that names line and column.
nlohmann::json parse_json(std::string_view text, const std::string& source);

// read(json, value, pointer): fills `value`; to be written as templates over Described values, numbers, strings,
// booleans, enumerations (by EnumNames), glm::dvec2/dvec3, std::optional (null), std::vector and std::array.
// write(value): the JSON, every field. schema<T>(): JSON Schema 2020-12 of a described type, with titles, ranges and
// defaults.

}  // namespace cloudscape::settings
