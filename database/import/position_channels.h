// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "database/import/bvh.h"

namespace flinch::database {

/// Brings the position channels of inner joints to one convention, that of forward_kinematics():
/// they replace OFFSET, and OFFSET is what they hold. Exporters differ in both. Files whose
/// channels hold displacements from OFFSET get OFFSET added to them. OFFSETs that differ from the
/// channels' values, such as those of an unscaled rig, get the medians over the motion, so that
/// bone lengths are the motion's.
///
/// Changes only joints whose channels are nearly constant relative to the parent, as bones are; the
/// root's are the figure's way and stay as they are. Returns a note for the user where channels
/// were taken for displacements.
std::optional<std::string> unify_position_channels(Bvh& bvh);

}  // namespace flinch::database
