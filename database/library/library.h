// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::motion {
class Loop;  // opaque: a stance's motion
}

namespace flinch::database {

/// The clips of one character, with its skeleton and its idle clip: what a selector chooses from.
///
/// Every clip begins with the pelvis on the vertical through the origin and the character facing
/// +X. All clips have the rate `rate_hz`.
struct ClipLibrary {
  std::string name;
  motion::Physique character;       ///< whose clips these are
  float rate_hz = 60;               ///< poses per second
  std::vector<motion::Clip> clips;  ///< their indices name them everywhere else
  int idle = 0;  ///< index of the clip that characters stand in, which is always a choice
  /// Hash of the file's content without the provenance, which identifies the library in stores and
  /// selectors. Reading and writing set it.
  std::uint64_t hash = 0;
  std::string provenance{};  ///< how it was made (database/files/provenance.h), or empty

  /// By index, which must be one of `clips`.
  const motion::Clip& clip(int index) const { return clips[static_cast<std::size_t>(index)]; }
  const motion::Clip& idle_clip() const { return clip(idle); }
};

/// The indices of the clips that a character may be in when it perceives: the idle clip, then those
/// of purpose `stance`, in their order. Their places in this list name them in scenarios.
std::vector<int> stance_clips(const ClipLibrary& library);

/// How clip number `clip` of them repeats: the idle clip back and forth, others in cycles. Refers
/// to the library.
motion::Loop loop_of(const ClipLibrary& library, int clip);

/// A library's hash in text: 16 hexadecimal digits, as messages and JSON have it.
std::string hash_text(std::uint64_t hash);

}  // namespace flinch::database
