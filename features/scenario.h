// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "features/threat.h"
#include "motion/body.h"

namespace flinch::motion {
class Loop;  // opaque: a stance's motion
}

namespace flinch::features {

/// Where a character is and how far it is in its stance when it perceives a threat.
struct CharacterState {
  float idle_time_s =
      0;  ///< time in the stance; the idle clip plays forwards and backwards in turn
  Eigen::Vector2f position = Eigen::Vector2f::Zero();  ///< added to the stance's own, world, m
  /// Turn of the whole stance about the vertical, radians counter-clockwise. Stances are stored
  /// facing +X, so the character faces this way; its pelvis may point elsewhere, as in a guard.
  float facing = 0;
  int stance = 0;  ///< which of the library's stances; 0 is the idle clip
};

/// The pose of a character that goes on in its stance, `time_s` after perception, world. `stance`
/// is that of the state (motion/loop.h). Sets the rotations of `roles` only.
motion::Pose idle_pose(const motion::Loop& stance, const CharacterState& state, float time_s,
                       std::span<const motion::Role> roles = motion::kRoles);

/// The state `time_s` later. Whole cycles of a stance go into its position and facing, so that the
/// time in the stance stays below a period; that of the idle clip goes on.
CharacterState later(const motion::Loop& stance, const CharacterState& state, float time_s);

/// A threat and the state of the character at perception: what a selector classifies.
struct Scenario {
  Threat threat;
  motion::Target target = motion::Target::head;  ///< which the threat will hit
  float time_to_impact_s = 0.5F;                 ///< from perception
  CharacterState state;
};

/// Whether a clip with this annotation may answer a threat to `threatened`: its target is that one
/// or its neighbour in the order head, trunk, pelvis, legs. Clips without an annotation never may.
/// Do not ask about the idle clip, which always may.
bool is_allowed(motion::Target threatened, const std::optional<motion::Annotation>& annotation);

}  // namespace flinch::features
