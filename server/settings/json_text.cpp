// JSON text to values with positions and duplicate keys found; values to short, safe text.
#include "settings/json_text.h"

#include <charconv>
#include <cmath>
#include <set>
#include <vector>

#include "core/error.h"

namespace cloudscape::settings {
namespace {

using nlohmann::json;

// Deeper than any document of ours, and shallow enough for every recursive walk.
constexpr std::size_t max_depth = 32;
constexpr std::size_t max_shown = 60;

std::string cut(std::string text) {
  if (text.size() > max_shown) text.replace(max_shown - 3, std::string::npos, "...");
  return text;
}

std::string ascii(const json& value) { return value.dump(-1, ' ', true, json::error_handler_t::replace); }

std::string ascii_without_quotes(std::string_view text) {
  const std::string quoted = ascii(json(text));
  return quoted.substr(1, quoted.size() - 2);
}

// Follows nlohmann's parser to refuse what it would accept: a key that stands twice, and bottomless nesting.
class StructureCheck {
 public:
  explicit StructureCheck(const std::string& source) : source_(source) {}

  bool operator()(int, json::parse_event_t event, json& parsed) {
    switch (event) {
      case json::parse_event_t::object_start:
      case json::parse_event_t::array_start:
        open(event == json::parse_event_t::object_start);
        break;
      case json::parse_event_t::key:
        key(parsed.get_ref<const std::string&>());
        break;
      case json::parse_event_t::object_end:
      case json::parse_event_t::array_end:
        levels_.pop_back();
        [[fallthrough]];
      case json::parse_event_t::value:
        if (!levels_.empty() && !levels_.back().object) ++levels_.back().index;
    }
    return true;
  }

 private:
  struct Level {
    bool object;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  void open(bool object) {
    if (levels_.size() == max_depth)
      throw InvalidInput("", source_ + " nests deeper than " + std::to_string(max_depth) + " levels");
    levels_.push_back({object, 0, {}, {}});
  }
  void key(const std::string& name) {
    levels_.back().key = name;
    if (!levels_.back().keys.insert(name).second) throw InvalidInput(pointer(), "stands twice: keep one of the two");
  }
  std::string pointer() const {
    std::string text;
    for (const Level& level : levels_)
      text += "/" + (level.object ? pointer_part(level.key) : std::to_string(level.index));
    return text;
  }

  const std::string& source_;
  std::vector<Level> levels_;
};

// nlohmann: "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ...".
std::string sentence_of(const json::exception& error) {
  const std::string_view what = error.what();
  constexpr std::string_view at = "parse error at ";
  if (const auto start = what.find(at); start != std::string_view::npos)
    return ascii_without_quotes(what.substr(start + at.size(), 300));
  return ascii_without_quotes(what.substr(what.find("] ") + 2, 100));
}

}  // namespace

json parse_json(std::string_view text, const std::string& source) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw InvalidInput("", source + " is empty: must be a JSON object");
  try {
    constexpr bool with_exceptions = true, with_comments = true;
    return json::parse(text, StructureCheck(source), with_exceptions, with_comments);
  } catch (const json::exception& error) {
    throw InvalidInput("", source + ": " + sentence_of(error));
  }
}

std::string to_text(const nlohmann::ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string number_text(double value) {
  std::array<char, 32> text;
  constexpr double exact_integers = 9007199254740992.0;  // 2^53
  const bool whole = std::abs(value) <= exact_integers && value == std::trunc(value);
  const auto end = whole ? std::to_chars(text.data(), text.data() + text.size(), static_cast<long long>(value))
                         : std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string range_text(const Limits& limits) {
  const std::string power = limits.power_of_two ? "a power of two " : "";
  if (limits.min == limits.max) return number_text(limits.min);
  if (std::isinf(limits.max)) return power + "at least " + number_text(limits.min);
  if (std::isinf(limits.min)) return power + "at most " + number_text(limits.max);
  return power + "within [" + number_text(limits.min) + ", " + number_text(limits.max) + "]";
}

std::string shown(const json& value) {
  if (value.is_number_float()) return number_text(value.get<double>());
  return cut(ascii(value));
}

std::string pointer_part(std::string_view name) {
  std::string escaped;
  for (const char c : cut(ascii_without_quotes(name))) {
    if (c == '~')
      escaped += "~0";
    else if (c == '/')
      escaped += "~1";
    else
      escaped += c;
  }
  return escaped;
}

void refuse(const std::string& pointer, const json& value, const std::string& must) {
  const std::string message = "is " + shown(value) + ": must be " + must;
  throw InvalidInput(pointer, pointer.empty() ? "the document " + message : message);
}

}  // namespace cloudscape::settings
