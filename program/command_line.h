// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>

#include "program/options.h"

namespace flinch::program {

/// Thrown for a command line that the program cannot carry out. what() says in one line what is
/// wrong and which help to read.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Stores the options of a command line, as main gets it, in their destinations. Returns the
/// function to call: a command's `run`, or one that prints a help text or the version. Throws
/// UsageError.
std::function<void()> parse(const Program& program, int argument_count,
                            const char* const* arguments);

}  // namespace flinch::program
