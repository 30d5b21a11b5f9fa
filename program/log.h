// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flinch::program {

/// How important a line on stderr is, the least important last.
enum class LogLevel { error, warning, info };

/// The names of --log-level: "error", "warning", "info".
std::vector<std::string> log_level_names();
LogLevel log_level_named(std::string_view name);

/// From now on only lines at least this important are shown. At first all are.
void set_log_level(LogLevel level);
/// Whether lines of this level are shown, for displays that write to stderr themselves.
bool is_logged(LogLevel level);

/// Writes a line to stderr at once, if its level is shown: to the byte, without time or level, so
/// that what a command prints does not depend on when it runs. Control characters are escaped.
void log(LogLevel level, std::string_view text);

/// Tells of something that may be wrong with the input or the result: "note: TEXT".
void log_note(std::string_view text);

}  // namespace flinch::program
