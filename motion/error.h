// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace flinch {

/// Thrown by offline code when its input cannot be used. Run-time code never throws; it returns a
/// status.
class Error : public std::runtime_error {
 public:
  /// `where` is "FILE", "FILE:LINE" or "FILE: byte N" and may be empty. `what` says what is wrong
  /// and what to do about it, in one line without a full stop.
  Error(const std::string& where, const std::string& what)
      : std::runtime_error(where.empty() ? what : where + ": " + what) {}
};

}  // namespace flinch
