// SPDX-License-Identifier: MIT
#include "features/poses_ahead.h"

#include <algorithm>

#include "motion/outline.h"
#include "motion/rotation.h"

namespace flinch::features {
namespace {

// A point's way between two poses is longer than the line, and its speed not even.
constexpr float kSpeedMargin = 1.25F;

struct Box {
  Eigen::Vector3f least;
  Eigen::Vector3f most;
};

Box box_of_pelvis(const motion::Motion& motion) {
  Box box{motion.poses.front().root_position, motion.poses.front().root_position};
  for (const motion::Pose& pose : motion.poses) {
    box.least = box.least.cwiseMin(pose.root_position);
    box.most = box.most.cwiseMax(pose.root_position);
  }
  return box;
}

/// The farthest that a point of the surface moves from one to the other: with its centre, and with
/// its turn about that.
double way_between(const motion::Outline& from, const motion::Outline& to) {
  const Eigen::Quaterniond turn = to.orientation * from.orientation.conjugate();
  return (to.centre - from.centre).norm() + motion::rotation_vector(turn).norm() * to.reach();
}

}  // namespace

Sway sway_of(const motion::Skeleton& skeleton, const motion::BodyModel& model,
             const motion::Motion& motion) {
  const Box box = box_of_pelvis(motion);
  Sway sway;
  sway.middle = 0.5F * (box.least + box.most);
  sway.radius = 0.5F * (box.most - box.least).norm();
  const auto outlines_at = [&](const motion::Pose& pose) {
    return outlines_of(model, forward_kinematics(skeleton, pose));
  };
  motion::PerBody<motion::Outline> from = outlines_at(motion.poses.front());
  double way_m = 0;
  for (const motion::Pose& pose : motion.poses) {
    const motion::PerBody<motion::Outline> to = outlines_at(pose);
    for (motion::Body body : motion::kBodies) {
      way_m = std::max(way_m, way_between(from[body], to[body]));
    }
    from = to;
  }
  sway.most_speed_mps = kSpeedMargin * static_cast<float>(way_m) * motion.rate_hz;
  return sway;
}

Sway placed(const Sway& sway, const CharacterState& state) {
  Sway result = sway;
  result.middle = motion::turn_about(Eigen::Vector3f::UnitZ(), state.facing) * sway.middle;
  result.middle.head<2>() += state.position;
  return result;
}

}  // namespace flinch::features
