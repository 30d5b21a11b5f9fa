// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// The clips of one character, with its skeleton and its idle clip: what a selector chooses from.
///
/// Every clip begins with the pelvis above the world's origin and the character facing +X. All
/// clips have the rate `rate_hz`.
struct ClipLibrary {
  std::string name;
  motion::Physique character;
  float rate_hz = 60;
  std::vector<motion::Clip> clips;
  int idle = 0;  ///< index of the clip that responses start from; it is always allowed
  /// Content hash of the file, which identifies the library in stores and selectors. Set by read
  /// and write.
  std::uint64_t hash = 0;
};

/// Returns a library's hash as in messages and JSON: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace flinch::database
