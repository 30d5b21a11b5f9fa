// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "program/command.h"

namespace {

constexpr int kError = 1;
constexpr int kWrongUsage = 2;

int fail(std::string message, int code) {
  std::ranges::replace(message, '\n', ' ');
  std::cerr << "flinch: " << message << '\n';
  return code;
}

/// The command that a wrong line was meant for, as --help is asked of it.
std::string help_of(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  return "see flinch " + (commands.empty() ? "" : commands.front()->get_name() + " ") + "--help";
}

int run(CLI::App& program, int argument_count, char** arguments) {
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
      return program.exit(error);  // --help and --version
    return fail(std::string(error.what()) + "; " + help_of(program), kWrongUsage);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", kError);
  } catch (const std::exception& error) {
    return fail(error.what(), kError);
  }
  if (!std::cout.flush()) return fail("cannot write to standard output", kError);
  return 0;
}

}  // namespace

int main(int argument_count, char** arguments) {
  using namespace flinch::program;
  CLI::App program("Flinch teaches a game character to anticipate impacts.", "flinch");
  program.set_version_flag("--version", "flinch " FLINCH_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Example:\n  flinch author --out default.flinchlib\n  flinch import mocap --manifest "
      "mocap/manifest.toml --out "
      "real.flinchlib\n  flinch simulate real.flinchlib --out real.flinchobs -n 2000\n"
      "  flinch train real.flinchobs --out real.flinch\n"
      "  flinch select real.flinch --azimuth 40 --target head\n\n"
      "flinch COMMAND --help tells more about each.");
  add_author(program);
  add_import(program);
  add_info(program);
  add_simulate(program);
  add_merge(program);
  add_train(program);
  add_compare(program);
  add_export(program);
  add_select(program);
  add_respond(program);
  return run(program, argument_count, arguments);
}
