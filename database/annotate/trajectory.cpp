// SPDX-License-Identifier: MIT
#include "database/annotate/trajectory.h"

#include <cmath>

#include "database/annotate/signals.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::Role;

constexpr double kSmoothingReach_s = 0.05;
constexpr double kMedianStep_s = 0.1;

// Appends the yaw that is nearest to the one before it.
void append_unwrapped(std::vector<float>& yaws, float yaw) {
  yaws.push_back(yaws.empty() ? yaw : yaws.back() + motion::wrapped_to_pi(yaw - yaws.back()));
}

Eigen::Vector3f velocity(const Trajectory& trajectory, Role role, std::size_t frame) {
  const std::size_t before = frame > 0 ? frame - 1 : frame;
  const std::size_t after = frame + 1 < trajectory.count() ? frame + 1 : frame;
  if (after == before) return Eigen::Vector3f::Zero();
  return (trajectory.joints[after][role] - trajectory.joints[before][role]) * trajectory.rate_hz /
         static_cast<float>(after - before);
}

}  // namespace

Trajectory trajectory_of(const motion::Figure& figure, const motion::Motion& motion) {
  Trajectory trajectory;
  trajectory.rate_hz = motion.rate_hz;
  for (const motion::Pose& pose : motion.poses) {
    const motion::JointFrames frames = motion::forward_kinematics(figure.skeleton(), pose);
    trajectory.joints.push_back(frames.position);
    trajectory.centre_of_mass.push_back(motion::centre_of_mass(figure.bodies, frames));
    append_unwrapped(trajectory.pelvis_yaw, motion::yaw_of(frames.orientation[Role::pelvis]));
    append_unwrapped(trajectory.head_yaw, motion::yaw_of(frames.orientation[Role::head]));
  }
  return trajectory;
}

std::vector<float> body_speed(const Trajectory& trajectory) {
  std::vector<float> speed;
  for (std::size_t i = 0; i < trajectory.count(); ++i) {
    float sum = 0;
    for (Role role : kTrackedJoints) sum += velocity(trajectory, role, i).squaredNorm();
    speed.push_back(std::sqrt(sum / static_cast<float>(kTrackedJoints.size())));
  }
  return moving_mean(speed, frames_in(kSmoothingReach_s, trajectory.rate_hz));
}

std::vector<JointPositions> relative_to_stance(const Trajectory& trajectory) {
  const std::vector<float> yaw =
      running_median(trajectory.pelvis_yaw, frames_in(kStanceReach_s, trajectory.rate_hz),
                     frames_in(kMedianStep_s, trajectory.rate_hz));
  std::vector<JointPositions> relative = trajectory.joints;
  for (std::size_t i = 0; i < relative.size(); ++i) {
    const Eigen::Vector3f pelvis = relative[i][Role::pelvis];
    const Eigen::Vector3f origin(pelvis.x(), pelvis.y(), 0);
    const Eigen::AngleAxisf turn(-yaw[i], Eigen::Vector3f::UnitZ());
    for (Eigen::Vector3f& joint : relative[i]) joint = turn * Eigen::Vector3f(joint - origin);
  }
  return relative;
}

std::vector<float> departure_from_stance(const std::vector<JointPositions>& relative,
                                         float rate_hz) {
  std::vector<JointPositions> stance(relative.size());
  std::vector<float> coordinate(relative.size());
  for (Role role : kTrackedJoints) {
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < relative.size(); ++i) coordinate[i] = relative[i][role][axis];
      const std::vector<float> median = running_median(
          coordinate, frames_in(kStanceReach_s, rate_hz), frames_in(kMedianStep_s, rate_hz));
      for (std::size_t i = 0; i < relative.size(); ++i) stance[i][role][axis] = median[i];
    }
  }
  std::vector<float> departure;
  for (std::size_t i = 0; i < relative.size(); ++i) {
    departure.push_back(pose_distance(relative[i], stance[i]));
  }
  return moving_mean(departure, frames_in(kSmoothingReach_s, rate_hz));
}

}  // namespace flinch::database
