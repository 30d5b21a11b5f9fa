// SPDX-License-Identifier: MIT
#include "program/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <iostream>
#include <optional>
#include <sstream>
#include <string_view>
#include <type_traits>

#include "motion/error.h"
#include "program/config_file.h"
#include "program/log.h"

namespace flinch::program {
namespace {

template <class Value>
struct OneValue {
  using Type = Value;
};
template <class Value>
struct OneValue<std::optional<Value>> {
  using Type = Value;
};

// CLI::Range accepts nan in every range.
CLI::Validator real_number_in(const Range& range) {
  std::ostringstream text;
  text << "[" << range.min << " - " << range.max << "]";
  const auto refusal = [range, text = text.str()](const std::string& input) {
    double value = 0;
    const bool in_range =
        CLI::detail::lexical_cast(input, value) && value >= range.min && value <= range.max;
    return in_range ? std::string() : "Value " + input + " not in range " + text;
  };
  return {refusal, "NUMBER in " + text.str()};
}

template <class Number>
CLI::Validator number_in(const Range& range) {
  if constexpr (std::is_integral_v<Number>)
    return CLI::Range(static_cast<Number>(range.min), static_cast<Number>(range.max));
  else
    return real_number_in(range);
}

/// Returns what follows the digits at the start of a text; nothing if there are none or their
/// number is not below 2^64.
std::optional<std::string_view> after_natural_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  return text.substr(static_cast<std::size_t>(end - text.data()));
}

/// Digits alone: CLI11 takes -3 for the number that 3 below 0 wraps round to, and a number that is
/// too large for the largest. Not part of help texts.
CLI::Validator natural_number() {
  const auto refusal = [](const std::string& input) {
    const bool is_natural = after_natural_number(input) == "";
    return is_natural ? std::string() : "Value " + input + " is not a whole number from 0 on";
  };
  return {refusal, ""};
}

/// The same with an optional unit.
CLI::Validator natural_number_with_unit() {
  const auto refusal = [](const std::string& input) {
    const std::optional<std::string_view> unit = after_natural_number(input);
    const bool is_natural = unit && unit->find_first_of("0123456789") == std::string_view::npos;
    return is_natural ? std::string() : "Value " + input + " is not a whole number from 0 on";
  };
  return {refusal, ""};
}

CLI::Validator one_of_or_file(const OneOfOrFile& accepted) {
  std::string text;
  for (const std::string& name : accepted.names) text += name + ", ";
  text += "FILE" + accepted.extension;
  const auto refusal = [accepted, text](const std::string& input) {
    const bool is_accepted = input.ends_with(accepted.extension) ||
                             std::ranges::find(accepted.names, input) != accepted.names.end();
    return is_accepted ? std::string() : input + " is none of " + text;
  };
  return {refusal, "{" + text + "}"};
}

/// Returns the number with the largest unit that leaves no remainder: 1G.
std::string byte_text(std::uint64_t bytes) {
  constexpr std::array kUnits{"", "K", "M", "G"};
  std::size_t unit = 0;
  for (; bytes > 0 && bytes % 1024 == 0 && unit + 1 < kUnits.size(); ++unit) bytes /= 1024;
  return std::to_string(bytes) + kUnits[unit];
}

CLI::Option* add_option(CLI::App& command, const Option& option, bool* value) {
  return command.add_flag(option.name, *value, option.help);
}

template <class Value>
CLI::Option* add_option(CLI::App& command, const Option& option, Value* value) {
  CLI::Option* added = command.add_option(option.name, *value, option.help);
  if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    if (std::holds_alternative<OneOf>(option.accepted)) added->delimiter(',');
  }
  using Number = typename OneValue<Value>::Type;
  if constexpr (std::is_integral_v<Number>) {
    if (!std::holds_alternative<ByteCount>(option.accepted)) added->check(natural_number());
  }
  if (const auto* range = std::get_if<Range>(&option.accepted)) {
    added->check(number_in<Number>(*range));
  } else if (const auto* one_of = std::get_if<OneOf>(&option.accepted)) {
    added->check(CLI::IsMember(one_of->names));
  } else if (const auto* named = std::get_if<OneOfOrFile>(&option.accepted)) {
    added->check(one_of_or_file(*named));
  } else if (std::holds_alternative<ByteCount>(option.accepted)) {
    added->transform(CLI::AsSizeValue(false));
    added->transform(natural_number_with_unit());  // the last transform is called first
  }
  return added;
}

CLI::Option* add_option(CLI::App& command, const Option& option) {
  return std::visit([&](auto* value) { return add_option(command, option, value); },
                    option.destination);
}

void show_default(const Option& option, CLI::Option* added) {
  if (std::holds_alternative<ByteCount>(option.accepted)) {
    added->default_str(byte_text(*std::get<std::uint64_t*>(option.destination)));
  } else if (!std::holds_alternative<std::vector<std::string>*>(option.destination)) {
    added->capture_default_str();  // of an empty list it would show []
  }
}

/// Returns the option or argument of this name; null for one that no file may set.
CLI::Option* configurable_option(CLI::App& command, const std::string& name) {
  if (name == "config" || name == "help") return nullptr;
  CLI::Option* option = command.get_option_no_throw((name.size() == 1 ? "-" : "--") + name);
  return option != nullptr ? option : command.get_option_no_throw(name);
}

/// Stores a file's value in an option that the command line leaves out.
void set_option(CLI::App& command, const ConfigValue& value) {
  CLI::Option* option = configurable_option(command, value.name);
  if (option == nullptr)
    throw Error(value.where, "[" + command.get_name() + "] has the key \"" + value.name +
                                 "\", which is no option; see flinch " + command.get_name() +
                                 " --help");
  const auto is_given = [](const CLI::Option* one) { return !one->empty(); };
  if (is_given(option) || std::ranges::any_of(option->get_excludes(), is_given)) return;
  try {
    option->add_result(value.values);
    option->run_callback();
  } catch (const CLI::ParseError& error) {
    throw Error(value.where, error.what());
  }
}

void add_config_option(CLI::App& command) {
  const auto read = [&command](const std::string& path) {
    std::vector<std::string> commands;
    for (const CLI::App* other : command.get_parent()->get_subcommands({}))
      commands.push_back(other->get_name());
    for (const ConfigValue& value : read_config(path, command.get_name(), commands))
      set_option(command, value);
  };
  command.add_option_function<std::string>(
      "--config", read, "TOML file with a table of options, [" + command.get_name() + "]");
}

/// What is written to stderr. A file may set these too.
void add_log_options(CLI::App& command) {
  CLI::Option* level =
      command
          .add_option_function<std::string>(
              "--log-level", [](const std::string& name) { set_log_level(log_level_named(name)); },
              "least important lines on standard error")
          ->check(CLI::IsMember(log_level_names()))
          ->default_str(log_level_names().back());
  command
      .add_flag_callback(
          "--quiet", [] { set_log_level(LogLevel::error); },
          "write nothing but an error to standard error: as --log-level error")
      ->excludes(level);
}

void add_command(CLI::App& app, const Command& command) {
  CLI::App* added = app.add_subcommand(command.name, command.summary);
  for (const Option& option : command.required) add_option(*added, option)->required();
  for (const Option& option : command.optional) show_default(option, add_option(*added, option));
  add_log_options(*added);
  add_config_option(*added);
  added->footer(command.notes);
}

}  // namespace

std::function<void()> parse(const Program& program, int argument_count,
                            const char* const* arguments) {
  CLI::App app(program.summary, program.name);
  app.set_version_flag("--version", program.version);
  app.require_subcommand(1);
  app.footer(program.notes);
  for (const Command& command : program.commands) add_command(app, command);

  std::function<void()> run;
  const auto chosen = [&] {
    const auto commands = app.get_subcommands();
    return commands.empty() ? std::string() : commands.front()->get_name();
  };
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    app.exit(asked, text);
    return [text = text.str()] { std::cout << text; };
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; see " + program.name + " " +
                     (chosen().empty() ? "" : chosen() + " ") + "--help");
  }
  return std::ranges::find(program.commands, chosen(), &Command::name)->run;
}

}  // namespace flinch::program
