// Settings of the server from file, environment and flags, each value checked where it comes from.
#include "settings/server_settings.h"

#include <algorithm>
#include <charconv>
#include <functional>

#include "core/log.h"
#include "settings/described_json.h"
#include "settings/text_file.h"
#include "settings/text_values.h"

namespace cloudscape::settings {
namespace {

using Where = std::function<std::string(const std::string& setting)>;  // what an error calls a setting

constexpr std::string_view prefix = "CLOUDSCAPE_";
constexpr std::array<std::string_view, 3> executions{"auto", "compute", "fragment"};
constexpr std::array<std::string_view, 5> log_levels{"debug", "info", "warn", "error", "off"};
constexpr std::size_t max_file_bytes = 256 * 1024;

std::span<const std::string_view> choices_of(std::string_view setting) {
  if (setting == "pass_execution") return executions;
  if (setting == "log_level") return log_levels;
  return {};
}

std::string with(std::string text, char from, char to) {
  std::replace(text.begin(), text.end(), from, to);
  return text;
}

bool is_address(const std::string& listen) {
  const auto colon = listen.rfind(':');
  if (colon == std::string::npos || colon == 0) return false;
  const char *first = listen.data() + colon + 1, *last = listen.data() + listen.size();
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(first, last, port);
  return error == std::errc() && end == last;
}

// What the fields' limits cannot say.
void check_values(const ServerSettings& settings, const Where& where) {
  ServerSettings::fields(settings, [&](std::string_view name, const auto& member, auto&&...) {
    if (const auto choices = choices_of(name); !choices.empty())
      detail::read_choice(write(member), where(std::string(name)), choices);
  });
  if (!is_address(settings.listen))
    refuse(where("listen"), settings.listen, "HOST:PORT, such as 127.0.0.1:8080 or [::1]:8080");
}

void apply_file(const std::filesystem::path& file, ServerSettings& settings) {
  const std::string name = file.string();
  read(parse_json(read_text_file(file, max_file_bytes), name), settings, name + "#");
  check_values(settings, [&](const std::string& setting) { return name + "#/" + setting; });
}

void apply_texts(const TextMap& texts, ServerSettings& settings, const Where& where) {
  ServerSettings::fields(settings, [&](std::string_view field, auto& member, const Limits& limits, std::string_view) {
    const std::string name(field);
    if (const auto text = texts.find(name); text != texts.end()) read_text(text->second, member, where(name), limits);
  });
  check_values(settings, where);
}

bool is_setting(const std::string& name) {
  const auto names = field_names<ServerSettings>();
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The settings that the environment names, by their names in the file.
TextMap settings_in(const TextMap& environment) {
  TextMap texts;
  for (const auto& [variable, text] : environment) {
    if (!variable.starts_with(prefix) || variable == "CLOUDSCAPE_TOKEN" || variable == "CLOUDSCAPE_CONFIG") continue;
    std::string name = variable.substr(prefix.size());
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (is_setting(name) && environment_name(name) == variable)
      texts[name] = text;
    else
      log::warn("the environment's {} is not a setting: {}", pointer_part(variable),
                suggestion(name, field_names<ServerSettings>()));
  }
  return texts;
}

void check_flags(const TextMap& flags) {
  for (const auto& [name, text] : flags)
    if (!is_setting(name))
      throw InvalidInput(flag_name(name), "is not a setting: " + suggestion(name, field_names<ServerSettings>()));
}

}  // namespace

std::string flag_name(const std::string& setting) { return "--" + with(setting, '_', '-'); }

std::string environment_name(const std::string& setting) {
  std::string name(prefix);
  for (const char c : setting) name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

ServerSettings load_server_settings(const std::optional<std::filesystem::path>& file, const TextMap& environment,
                                    const TextMap& flags) {
  ServerSettings settings;
  if (file) apply_file(*file, settings);
  apply_texts(settings_in(environment), settings, environment_name);
  check_flags(flags);
  apply_texts(flags, settings, flag_name);
  if (settings.idle_hangup_s <= settings.idle_ping_s)
    refuse("idle_hangup_s", settings.idle_hangup_s, "more than idle_ping_s, " + number_text(settings.idle_ping_s));
  return settings;
}

std::vector<ParameterInfo> server_parameters() {
  std::vector<ParameterInfo> parameters;
  const ServerSettings defaults;
  ServerSettings::fields(
      defaults, [&](std::string_view name, const auto& member, const Limits& limits, std::string_view meaning) {
        parameters.push_back(describe(std::string(name), member, limits, meaning));
        const auto choices = choices_of(name);
        parameters.back().values.assign(choices.begin(), choices.end());
      });
  return parameters;
}

StillLimits still_limits(const ServerSettings& settings) {
  return {settings.max_still_side_px, settings.max_still_megapixels, settings.max_still_gigasteps,
          settings.max_bake_mib};
}

SequenceLimits sequence_limits(const ServerSettings& settings) {
  return {still_limits(settings), settings.max_job_frames, settings.max_job_gigasteps};
}

}  // namespace cloudscape::settings
