// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "database/import/source_motion.h"
#include "motion/skeleton.h"

namespace flinch::database {

/// Where the ankles of a skeleton must be in each frame for its feet to do as a source's feet do.
using AnkleGoals = std::array<Eigen::Vector3f, 2>;  ///< left, right, m

/// Ankle positions for a sequence of a source's frames at a fixed interval, in the source's world
/// scaled by `scale`, heights from the ground.
///
/// The two feet differ in length, so ankle and ball cannot both follow: the point of the foot about
/// which the source's foot turns at the moment does. Where the foot has thus been led away from the
/// source's, it comes back while it is in the air. Heights follow the ankle or the ball, whichever
/// is nearer to the ground, and no point of the sole is under it.
std::vector<AnkleGoals> compute_ankle_goals(const SourceMotion& source,
                                            const motion::Skeleton& skeleton,
                                            const std::vector<SourceFrame>& frames,
                                            float interval_s, float scale);

}  // namespace flinch::database
