// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "database/quality/joint_positions.h"
#include "motion/clip.h"
#include "motion/figure.h"

namespace flinch::database {

/// Where a motion takes the joints. All vectors have one element per pose.
struct Trajectory {
  float rate_hz = 60;
  std::vector<JointPositions> joints;
  std::vector<Eigen::Vector3f> centre_of_mass;  ///< m
  std::vector<float> pelvis_yaw;                ///< radians, without jumps by a whole turn
  std::vector<float> head_yaw;                  ///< likewise

  std::size_t count() const { return joints.size(); }
};

/// Returns the trajectory of a motion in the world.
Trajectory trajectory_of(const motion::Figure& figure, const motion::Motion& motion);

/// Returns the root mean square of the speeds of kTrackedJoints, m/s, smoothed over 0.1 s.
std::vector<float> body_speed(const Trajectory& trajectory);

/// Reach of the running median that gives a stance, s: longer than a movement to either side, so
/// that most of the window is stance.
inline constexpr double kStanceReach_s = 3;

/// Returns the joints as seen from the stance: relative to the pelvis on the ground, in axes that
/// turn with the running median of its yaw. Footwork and slow turns drop out; a twist of the body
/// stays.
std::vector<JointPositions> relative_to_stance(const Trajectory& trajectory);

/// Returns each pose's distance, m, from the stance: the running median of the joints relative to
/// it. Smoothed over 0.1 s.
std::vector<float> departure_from_stance(const std::vector<JointPositions>& relative,
                                         float rate_hz);

}  // namespace flinch::database
