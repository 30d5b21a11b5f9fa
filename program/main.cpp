// SPDX-License-Identifier: MIT
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "database/import/role_map.h"
#include "program/command.h"
#include "program/command_line.h"
#include "program/log.h"
#include "program/safe_writing.h"

namespace {

constexpr int kError = 1;
constexpr int kWrongUsage = 2;

int fail(const std::string& message, int code) {
  flinch::program::log(flinch::program::LogLevel::error, "flinch: " + message);
  return code;
}

flinch::program::Program flinch_program() {
  using namespace flinch::program;
  return {.name = "flinch",
          .summary = "Flinch teaches a game character to anticipate impacts.",
          .version = "flinch " FLINCH_VERSION,
          .notes =
              "Example:\n  flinch author --out default.flinchlib\n  flinch import mocap --manifest "
              "mocap/manifest.toml --out "
              "real.flinchlib\n  flinch simulate real.flinchlib --out real.flinchobs -n 2000\n"
              "  flinch train real.flinchobs --out real.flinch\n"
              "  flinch select real.flinch --azimuth 40 --target head\n\n"
              "flinch COMMAND --help explains each command.",
          .commands = {author_command(), import_command(), annotate_command(), info_command(),
                       simulate_command(), merge_command(), train_command(), compare_command(),
                       export_command(), select_command(), respond_command(), threats_command(),
                       evolve_command(), push_command(), label_command(), train_realism_command(),
                       view_command()}};
}

}  // namespace

int main(int argument_count, char** arguments) {
  using namespace flinch::program;
  make_writes_safe();
  try {
    parse(flinch_program(), argument_count, arguments)();
  } catch (const UsageError& error) {
    return fail(error.what(), kWrongUsage);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", kError);
  } catch (const flinch::database::RoleError& error) {
    const int code = fail(error.what(), kError);
    std::cerr << error.suggestion;
    return code;
  } catch (const std::exception& error) {
    return fail(error.what(), kError);
  }
  if (!std::cout.flush()) return fail("cannot write to standard output", kError);
  return 0;
}
