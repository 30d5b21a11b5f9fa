// SPDX-License-Identifier: MIT
#include "evolve/trial/move_time.h"

#include <algorithm>

#include "database/quality/quality.h"
#include "motion/joint_limits.h"
#include "motion/rotation.h"

namespace flinch::evolve {

// The eased path 3 s^2 - 2 s^3 is 3/2 times as fast in its middle as on average.
double move_time_s(const motion::Figure& figure, const motion::Pose& from, const motion::Pose& to) {
  const motion::JointFrames before = forward_kinematics(figure.skeleton(), from);
  const motion::JointFrames after = forward_kinematics(figure.skeleton(), to);
  double time_s = kMinMove_s;
  for (const motion::JointLimits& limits : motion::human_joint_limits()) {
    const float angle = relative_rotation(before, limits.from, limits.to)
                            .angularDistance(relative_rotation(after, limits.from, limits.to));
    const float peak = motion::radians(database::peak_human_speed_dps(limits.name));
    time_s = std::max(time_s, 1.5 * static_cast<double>(angle / peak));
  }
  return time_s;
}

}  // namespace flinch::evolve
