// SPDX-License-Identifier: MIT
#include "features/predicted_motion.h"

#include <algorithm>
#include <cmath>

#include "motion/collision_shape.h"
#include "motion/rotation.h"

namespace flinch::features {
namespace {

// Between two poses a point follows an arc, longer than the chord and at uneven speed.
constexpr float kSpeedMargin = 1.25F;

struct BoundingBox {
  Eigen::Vector3f min;
  Eigen::Vector3f max;
};

BoundingBox pelvis_bounding_box(const motion::Motion& motion) {
  BoundingBox box{motion.poses.front().root_position, motion.poses.front().root_position};
  for (const motion::Pose& pose : motion.poses) {
    box.min = box.min.cwiseMin(pose.root_position);
    box.max = box.max.cwiseMax(pose.root_position);
  }
  return box;
}

/// Upper bound on the displacement of a surface point from one shape to the other: that of the
/// centre plus that by rotation about the centre.
double max_displacement(const motion::CollisionShape& from, const motion::CollisionShape& to) {
  const Eigen::Quaterniond turn = to.orientation * from.orientation.conjugate();
  return (to.centre - from.centre).norm() + motion::rotation_vector(turn).norm() * to.reach();
}

}  // namespace

MotionBounds motion_bounds_of(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                              const motion::Motion& motion) {
  const BoundingBox box = pelvis_bounding_box(motion);
  MotionBounds bounds;
  bounds.pelvis_centre = 0.5F * (box.min + box.max);
  bounds.radius = 0.5F * (box.max - box.min).norm();
  const auto outlines_at = [&](const motion::Pose& pose) {
    return collision_shapes_of(model, forward_kinematics(skeleton, pose));
  };
  motion::PerBody<motion::CollisionShape> from = outlines_at(motion.poses.front());
  double displacement_m = 0;
  for (const motion::Pose& pose : motion.poses) {
    const motion::PerBody<motion::CollisionShape> to = outlines_at(pose);
    for (motion::Body body : motion::kBodies) {
      displacement_m = std::max(displacement_m, max_displacement(from[body], to[body]));
    }
    from = to;
  }
  bounds.max_speed_mps = kSpeedMargin * static_cast<float>(displacement_m) * motion.rate_hz;
  return bounds;
}

MotionBounds placed(const MotionBounds& bounds, const motion::Loop& stance,
                    const CharacterState& state, float horizon_s) {
  MotionBounds result = bounds;
  const CharacterState now = later(stance, state, 0);
  result.pelvis_centre =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), now.facing) * bounds.pelvis_centre;
  result.pelvis_centre.head<2>() += now.position;
  // The cycles that begin within the horizon are each farther along by at most the way of one.
  const float cycles = stance.has_cycles() ? std::ceil(horizon_s / stance.period_s()) : 0;
  if (cycles > 0) {
    const float turned_m = std::abs(stance.travel().yaw) * bounds.pelvis_centre.head<2>().norm();
    result.radius += cycles * (stance.travel().translation.norm() + turned_m);
  }
  return result;
}

}  // namespace flinch::features
