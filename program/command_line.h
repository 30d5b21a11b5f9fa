// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>

#include "program/options.h"

namespace flinch::program {

/// A command line that asks for nothing that the program can do. what() says in a line what is
/// wrong with it, and which help to read.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Puts the options of a command line, as main gets it, in their destinations. Returns what it asks
/// for, to be called: a command's `run`, or to print a help text or the version. Throws UsageError.
std::function<void()> parse(const Program& program, int argument_count,
                            const char* const* arguments);

}  // namespace flinch::program
