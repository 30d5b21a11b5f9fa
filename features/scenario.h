// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "features/threat.h"
#include "motion/body.h"

namespace flinch::features {

/// Where a character stands and how far it is in its idle clip when it perceives a threat.
struct CharacterState {
  float idle_time_s = 0;  ///< time in the idle clip, which plays forwards and backwards in turn
  Eigen::Vector2f position = Eigen::Vector2f::Zero();  ///< added to the idle clip's own, world, m
  /// Turn of the whole idle clip about the vertical, radians counter-clockwise. Idle clips are
  /// stored facing +X, so the character faces this way; its pelvis may point elsewhere, as in a
  /// guard.
  float facing = 0;
};

/// The pose of an idling character `time_s` after perception, world. `idle` has at least one pose.
/// Sets the rotations of `roles` only.
motion::Pose idle_pose(const motion::Motion& idle, const CharacterState& state, float time_s,
                       std::span<const motion::Role> roles = motion::kRoles);

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
