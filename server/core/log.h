// The log: lines on stderr through spdlog. Call as log::info("baked {} in {} ms", name, ms).
#pragma once
#include <spdlog/spdlog.h>

#include <string_view>

namespace cloudscape::log {
using spdlog::debug;
using spdlog::error;
using spdlog::info;
using spdlog::warn;

// Sends the log to stderr with lines "2026-11-21 12:00:00.123 info ..."; `level` is debug, info, warn or error.
// Throws InvalidInput for another level.
void start(std::string_view level);
}  // namespace cloudscape::log
