// SPDX-License-Identifier: MIT
#include "program/log.h"

#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <algorithm>
#include <array>
#include <memory>

#include "program/printable.h"

namespace flinch::program {
namespace {

struct NamedLevel {
  std::string_view name;
  LogLevel level;
  spdlog::level::level_enum shown;
};
constexpr std::array kLevels{NamedLevel{"error", LogLevel::error, spdlog::level::err},
                             NamedLevel{"warning", LogLevel::warning, spdlog::level::warn},
                             NamedLevel{"info", LogLevel::info, spdlog::level::info}};

spdlog::level::level_enum shown(LogLevel level) {
  return std::ranges::find(kLevels, level, &NamedLevel::level)->shown;
}

/// The process has one stderr, and this writes to it.
spdlog::logger& logger() {
  static spdlog::logger only = [] {
    spdlog::logger made("flinch", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    made.set_pattern("%v");
    made.set_level(spdlog::level::info);
    made.flush_on(spdlog::level::info);
    return made;
  }();
  return only;
}

}  // namespace

std::vector<std::string> log_level_names() {
  std::vector<std::string> names;
  for (const NamedLevel& level : kLevels) names.emplace_back(level.name);
  return names;
}

LogLevel log_level_named(std::string_view name) {
  return std::ranges::find(kLevels, name, &NamedLevel::name)->level;
}

void set_log_level(LogLevel level) {
  logger().set_level(shown(level));
}

bool is_logged(LogLevel level) {
  return logger().should_log(shown(level));
}

void log(LogLevel level, std::string_view text) {
  logger().log(shown(level), "{}", printable(text));
}

void log_note(std::string_view text) {
  log(LogLevel::warning, "note: " + std::string(text));
}

}  // namespace flinch::program
