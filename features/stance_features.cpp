// SPDX-License-Identifier: MIT
#include "features/stance_features.h"

#include <algorithm>

#include "motion/foot.h"
#include "motion/rotation.h"

namespace flinch::features {

// The weight is taken to be shared as by a beam on two supports, by the distances of the centre of
// mass from both ankles along the ground. A foot that is higher than the other by kLifted_m carries
// none.
StanceFeatures stance_features(const IdlingFigure& figure, const CharacterState& state,
                               float time_s) {
  constexpr float kInterval_s = 1.0F / 60;
  constexpr float kLeast_m = 1e-3F;
  constexpr float kLifted_m = 0.03F;
  const motion::Pose now = idle_pose(figure.stance, state, time_s);
  const motion::Pose before = idle_pose(figure.stance, state, time_s - kInterval_s);
  const Eigen::Quaternionf heading =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), later(figure.stance, state, time_s).facing)
          .conjugate();
  const Eigen::Vector3f velocity =
      heading * ((now.root_position - before.root_position) / kInterval_s);
  const motion::JointFrames frames = motion::forward_kinematics(*figure.skeleton, now);
  const Eigen::Vector3f centre = motion::centre_of_mass(*figure.model, frames);
  const auto distance = [&](motion::Side side) {
    return (motion::foot_pose(frames, side).ankle - centre).head<2>().norm() + kLeast_m;
  };
  const auto ball_height = [&](motion::Side side) {
    return frames.position[motion::roles_of(side).toes].z();
  };
  const auto weight = [&](motion::Side side) {
    const motion::Side other = motion::other(side);
    const float higher_m = std::max(ball_height(side) - ball_height(other), 0.0F);
    return std::max(1 - higher_m / kLifted_m, 0.0F) * distance(other);
  };
  const float left = weight(motion::Side::left);
  const float right = weight(motion::Side::right);
  const Eigen::Vector3f origin(now.root_position.x(), now.root_position.y(), 0);
  const auto place = [&](motion::Role role) -> Eigen::Vector3f {
    return heading * (frames.position[role] - origin);
  };
  const Eigen::Vector3f left_hand = place(motion::Role::left_hand);
  const Eigen::Vector3f right_hand = place(motion::Role::right_hand);
  const float turn = motion::wrapped_to_pi(motion::facing(now) - motion::facing(before));
  return {velocity.x(),  velocity.y(),  turn / kInterval_s, left / (left + right), left_hand.x(),
          left_hand.y(), left_hand.z(), right_hand.x(),     right_hand.y(),        right_hand.z()};
}

}  // namespace flinch::features
