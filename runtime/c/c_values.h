// SPDX-License-Identifier: MIT
#pragma once

#include "database/library/file_header.h"
#include "features/threat.h"
#include "lookahead/look_ahead.h"
#include "models/selector.h"
#include "motion/skeleton.h"
#include "reaction/reacting_character.h"
#include "runtime/c/flinch.h"
#include "runtime/character.h"

namespace flinch::runtime {

/// Converts statuses and values between the C interface and C++. Structs of the C interface have
/// been checked (see c_struct.h); members that they lack have their default.

flinch_status status_of(Status status) noexcept;
flinch_status status_of(database::LoadStatus status) noexcept;
flinch_status status_of(reaction::ReactionStatus status) noexcept;

/// With what a selector knows of its kind. A kind that it does not know becomes -1, which no call
/// takes.
features::Threat threat_of(const flinch_threat& threat, const models::Selector& selector);
/// The threat as a game would hand it over; of its kind only the number.
flinch_threat to_c(const features::Threat& threat);
PerceptionLimits limits_of(const flinch_perception_limits& limits);
Mask mask_of(const flinch_mask& mask);
motion::Pose pose_of(const flinch_pose& pose);

flinch_perception_limits to_c(const PerceptionLimits& limits);
flinch_pose to_c(const motion::Pose& pose);
flinch_joint_frames to_c(const motion::JointFrames& frames);
flinch_skeleton to_c(const motion::Skeleton& skeleton);
flinch_outline to_c(motion::Body body, const motion::BodyProperties& properties);
flinch_reaction to_c(const reaction::ReactingCharacter& character);
/// The result refers to the clip's strings.
flinch_clip to_c(const motion::Clip& clip);
/// The result refers to the kind's name.
flinch_kind to_c(const features::KnownKind& kind);

/// Defaults for a struct that leaves out the budget: no limit.
lookahead::LookAhead look_ahead_of(const flinch_look_ahead_options& options);
flinch_look_ahead_status to_c(const lookahead::LookAheadStatus& status);

/// Whether all weights are in [0, 1].
bool is_valid(const Mask& mask);

}  // namespace flinch::runtime
