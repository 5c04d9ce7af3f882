// Takes events; gives one line each, for people or for machines.
#pragma once

#include <memory>
#include <spdlog/formatter.h>
#include <spdlog/logger.h>

namespace billiards::server {

enum class LogFormat { Text, Json };

/// Writes `2026-01-31T20:15:03.123Z warning message`, or the same as one JSON object. Whatever the
/// message holds, it stays on its line: control characters are escaped.
std::unique_ptr<spdlog::formatter> make_line_formatter(LogFormat format);

/// To standard error.
std::shared_ptr<spdlog::logger> make_logger(LogFormat format);

}  // namespace billiards::server
