// SPDX-License-Identifier: MIT
#include "runtime/response/brace.h"

#include <cmath>

#include "motion/rotation.h"

namespace flinch::runtime {

// A pelvis takes most of the body along; the feet stay, so it must go a little farther. The thesis
// minimises equation 3.3 over the pelvis and the controls; moving the pelvis alone reaches the same
// place of the centre of mass and leaves the rules as they are.
motion::Pose braced_pose(const motion::Figure& figure, const motion::Pose& pose,
                         const database::AimedThreat& threat,
                         const database::RuleControls& controls,
                         const motion::PerSide<motion::FootPose>& feet) {
  constexpr float kOvershoot = 1.17F;
  constexpr float kNear_m = 1e-3F;
  constexpr int kRounds = 5;
  const database::ThreatGeometry geometry = database::threat_geometry(figure, pose, threat);
  const Eigen::Vector2f toward = geometry.to_threat.head<2>().normalized();
  const auto shifted = [&](const Eigen::Vector2f& shift_m) {
    motion::Pose moved = pose;
    moved.root_position.head<2>() += shift_m;
    return database::apply_rules(figure, moved, geometry, controls, feet);
  };
  const auto centre_of = [&](const motion::Pose& at) -> Eigen::Vector2f {
    return motion::centre_of_mass(figure.bodies, motion::forward_kinematics(figure.skeleton(), at))
        .head<2>();
  };
  Eigen::Vector2f shift_m = Eigen::Vector2f::Zero();
  motion::Pose braced = shifted(shift_m);
  const Eigen::Vector2f goal = centre_of(braced) + database::kBraceDistance * toward;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Vector2f missing = goal - centre_of(braced);
    if (missing.norm() < kNear_m) break;
    shift_m += kOvershoot * missing;
    braced = shifted(shift_m);
  }
  return braced;
}

}  // namespace flinch::runtime
