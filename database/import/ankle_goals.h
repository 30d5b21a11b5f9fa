// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "database/import/source_motion.h"
#include "motion/skeleton.h"

namespace flinch::database {

/// Target positions of a skeleton's ankles in one frame, so that its feet move like a source's.
using AnkleGoals = std::array<Eigen::Vector3f, 2>;  ///< left, right, m

/// Computes ankle positions for a sequence of a source's frames at a fixed interval, in the
/// source's world scaled by `scale`, with heights from the ground.
///
/// The feet of source and skeleton differ in length, so ankle and ball cannot both follow the
/// source; the point of the foot about which the source's foot rotates at the time does. The offset
/// from the source's foot that results is reduced while the foot is in the air. Heights follow the
/// ankle or the ball, whichever is nearer to the ground, and no point of the sole is below it.
std::vector<AnkleGoals> compute_ankle_goals(const SourceMotion& source,
                                            const motion::Skeleton& skeleton,
                                            const std::vector<SourceFrame>& frames,
                                            float interval_s, float scale);

}  // namespace flinch::database
