// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "features/threat.h"
#include "motion/body.h"

namespace flinch::features {

/// The character when it perceives: somewhere in its idle clip, standing somewhere.
struct CharacterState {
  float idle_time_s = 0;  ///< into the idle clip, which goes to and fro
  Eigen::Vector2f position = Eigen::Vector2f::Zero();  ///< added to the idle clip's own, world, m
  /// Turn of the whole idle clip about the vertical, radians. Idle clips are stored facing +X, so
  /// this is the way that the character faces; its pelvis may be turned from it, as in a stance.
  float facing = 0;
};

/// The pose of an idling character `time_s` after perception, world. `idle` has at least one pose.
/// Where `roles` are not all, the rotations of others are not set.
motion::Pose idle_pose(const motion::Motion& idle, const CharacterState& state, float time_s,
                       std::span<const motion::Role> roles = motion::kRoles);

/// A threat and the character's state at perception: what is classified.
struct Scenario {
  Threat threat;
  motion::Target target = motion::Target::head;
  float time_to_impact_s = 0.5F;
  CharacterState state;
};

/// A clip is tried on a scenario only when its target is the scenario's or that target's neighbour
/// in head - trunk - pelvis - legs. Clips without an annotation never are. The idle clip always is,
/// and is not asked about here.
bool is_allowed(motion::Target threatened, const std::optional<motion::Annotation>& annotation);

}  // namespace flinch::features
