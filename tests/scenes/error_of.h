// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "motion/error.h"

namespace flinch::tests {

/// Returns the message of the Error that `action` throws; empty when it throws none.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace flinch::tests
