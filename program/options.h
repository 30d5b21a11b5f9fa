// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace flinch::program {

/// Where an option puts its value: a bool is a flag, a vector takes one value or more.
using Destination =
    std::variant<bool*, std::uint64_t*, double*, std::string*, std::optional<int>*,
                 std::optional<double>*, std::optional<std::string>*, std::vector<std::string>*>;

/// Numbers from `min` to `max`, and not nan.
struct Range {
  double min = 0;
  double max = 0;
};

/// One of these names. An option with several values also takes them separated by commas.
struct OneOf {
  std::vector<std::string> names;
};

/// A number of bytes, which may have a unit: 512M, 2G.
struct ByteCount {};

/// The values that an option accepts, of all that its destination can hold; monostate: every one.
using Accepted = std::variant<std::monostate, Range, OneOf, ByteCount>;

/// A name without dashes is that of an argument, told by its position. The destination's value
/// before parsing is the default; help shows it unless it is empty.
struct Option {
  std::string name;
  std::string help;
  Destination destination;
  Accepted accepted{};
};

/// The lists one after another.
inline std::vector<Option> join(std::initializer_list<std::vector<Option>> lists) {
  std::vector<Option> all;
  for (const std::vector<Option>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// A command of the program. `run` is called after the options are in their destinations; it throws
/// Error for what a user can put right.
struct Command {
  std::string name;
  std::string summary;           ///< its line in the program's help
  std::vector<Option> required;  ///< arguments in the order of the command line
  std::vector<Option> optional;
  std::string notes;  ///< the end of its help: what else to know, and an example
  std::function<void()> run;
};

/// The whole command line.
struct Program {
  std::string name;
  std::string summary;
  std::string version;
  std::string notes;
  std::vector<Command> commands;
};

}  // namespace flinch::program
