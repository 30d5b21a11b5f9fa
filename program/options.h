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

/// Where an option stores its value: a bool is a flag, a vector takes one or more values.
using Destination = std::variant<bool*, std::uint64_t*, double*, std::string*, std::optional<int>*,
                                 std::optional<std::uint64_t>*, std::optional<double>*,
                                 std::optional<std::string>*, std::vector<std::string>*>;

/// Accepts numbers from `min` to `max`, and not nan.
struct Range {
  double min = 0;
  double max = 0;
};

/// Accepts one of these names. An option with several values also accepts them separated by commas.
struct OneOf {
  std::vector<std::string> names;
};

/// Accepts one of these names, or that of a file with this extension (".toml").
struct OneOfOrFile {
  std::vector<std::string> names;
  std::string extension;
};

/// Accepts a number of bytes, which may have a unit: 512M, 2G.
struct ByteCount {};

/// Restricts the values that an option accepts; monostate: every value that its destination can
/// hold.
using Accepted = std::variant<std::monostate, Range, OneOf, OneOfOrFile, ByteCount>;

/// An option or argument. A name without dashes is that of an argument, which is recognised by its
/// position. The destination's value before parsing is the default; help shows it unless it is
/// empty.
struct Option {
  std::string name;
  std::string help;
  Destination destination;
  Accepted accepted{};
};

/// Concatenates lists of options.
inline std::vector<Option> join(std::initializer_list<std::vector<Option>> lists) {
  std::vector<Option> all;
  for (const std::vector<Option>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// A command of the program. `run` is called after the options have been stored; it throws Error
/// for problems that the user can solve.
struct Command {
  std::string name;
  std::string summary;           ///< one line for the program's help
  std::vector<Option> required;  ///< arguments in the order of the command line
  std::vector<Option> optional;
  std::string notes;  ///< end of its help: further explanation, and an example
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
