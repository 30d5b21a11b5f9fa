// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

namespace flinch::program {

/// The values that a file gives one option or argument of a command.
struct ConfigValue {
  std::string name;                 ///< as the command line has it, without dashes
  std::vector<std::string> values;  ///< as the command line has them; at least one
  std::string where;                ///< "FILE:LINE", for messages
};

/// Reads a command's options from a TOML file with a table per command:
///
///     [train]
///     STORE = "game.flinchobs"
///     model = "svm"
///
/// Throws Error "FILE:LINE: …" for a file that cannot be read, a table that is none of `commands`,
/// and values that are no text, number, truth value or list of these; and if the file has no table
/// of this command.
std::vector<ConfigValue> read_config(const std::string& path, const std::string& command,
                                     std::span<const std::string> commands);

}  // namespace flinch::program
