// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include "database/author/stance.h"
#include "database/rules/pose_rules.h"
#include "motion/default_character.h"
#include "motion/rotation.h"

namespace flinch::database::test {

using motion::degrees;
using motion::radians;

/// The default character in its relaxed standing pose.
struct AuthorScene {
  motion::Figure figure = motion::make_figure(motion::default_character());
  motion::Pose start = standing_pose(figure);
  motion::JointFrames frames = motion::forward_kinematics(figure.skeleton(), start);

  /// Returns a threat 5 m away, aimed at the centre of a target, from an azimuth in degrees.
  AimedThreat threat(motion::Target target, float azimuth_deg, float height_m = 0) const {
    AimedThreat made;
    made.target_point = motion::target_centre(figure.bodies, frames, target);
    const float azimuth = radians(azimuth_deg);
    const Eigen::Vector3f from(5 * std::cos(azimuth), 5 * std::sin(azimuth), height_m);
    made.threat.position = made.target_point + from;
    made.threat.velocity = -25 * from.normalized();
    return made;
  }
};

inline bool is_finite(const motion::Pose& pose) {
  bool finite = pose.root_position.allFinite();
  for (const Eigen::Quaternionf& rotation : pose.rotation) {
    finite = finite && rotation.coeffs().allFinite();
  }
  return finite;
}

/// Returns the angle of a rotation about its known axis, degrees.
inline float angle_about(const Eigen::Quaternionf& rotation, const Eigen::Vector3f& axis) {
  return degrees(2 * std::atan2(rotation.vec().dot(axis), rotation.w()));
}

}  // namespace flinch::database::test
