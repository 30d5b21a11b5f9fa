// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/annotate/protection.h"

namespace flinch::database {

/// One entry of a drafted manifest. Times are seconds from the start of the file.
struct DraftClip {
  std::string name;  ///< kind, height, side and number: "duck_high_front_1"
  Guess<MovementKind> kind;
  Protection protection;
  double start_s = 0;
  double onset_s = 0;  ///< of a push: its contact
  double peak_s = 0;
  double end_s = 0;
  float heading = 0;  ///< see ManifestEntry, radians
};

/// The idle clip of a drafted manifest.
struct DraftIdle {
  double start_s = 0;
  double end_s = 0;
  float confidence = 0;
  std::string reason;
  float heading = 0;
};

/// A span of a file, s.
struct TimeSpan {
  double start_s = 0;
  double end_s = 0;
};

/// What a take seems to hold.
struct Draft {
  DraftIdle idle;
  std::vector<DraftClip> clips;  ///< in the order of the take; may be empty
  std::vector<TimeSpan> still;
  float still_limit_mps = 0;  ///< see still_limit
};

/// Drafts a manifest for a take: the idle, and each movement between two returns to stillness or to
/// the stance, with kind, onset, peak, target and direction as the motion suggests them. Throws
/// Error for a take that is never calm enough for an idle clip.
Draft draft_of(const Take& take);

}  // namespace flinch::database
