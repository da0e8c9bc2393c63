#include "core/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>

#include <string>

#include "core/error.h"

namespace cloudscape::log {

void start(std::string_view level) {
  const auto parsed = spdlog::level::from_str(level == "warn" ? "warning" : std::string(level));
  if (parsed == spdlog::level::off && level != "off")
    throw InvalidInput("--log-level", "is '" + std::string(level) + "': must be debug, info, warn, error or off");
  auto logger = spdlog::stderr_color_mt("cloudscape");
  logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %^%l%$ %v");
  logger->set_level(parsed);
  spdlog::set_default_logger(std::move(logger));
}

}  // namespace cloudscape::log
