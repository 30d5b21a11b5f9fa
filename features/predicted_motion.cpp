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

/// Where a body's shape is.
struct Place {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// Where the shapes, each in the frame of its body's joint, are in a pose.
motion::PerBody<Place> places_of(const motion::PerBody<motion::CollisionShape>& shapes,
                                 const motion::JointFrames& frames) {
  motion::PerBody<Place> places;
  for (const motion::Body body : motion::kBodies) {
    const motion::Role role = motion::role_of(body);
    const Eigen::Quaterniond joint = frames.orientation[role].cast<double>();
    places[body].centre = frames.position[role].cast<double>() + joint * shapes[body].centre;
    places[body].orientation = joint * shapes[body].orientation;
  }
  return places;
}

/// Upper bound on the displacement of a surface point of a shape that moves from one place to the
/// other, that of the centre plus that by rotation about the centre, or `least` if that is more.
double max_displacement(const Place& from, const Place& to, double reach_m, double least) {
  const Eigen::Quaterniond turn = to.orientation * from.orientation.conjugate();
  const double shift = (to.centre - from.centre).norm();
  // An angle is at most pi times the sine of its half, which spares most poses the arc tangent.
  constexpr double kMaxAnglePerSine = 3.1416;
  if (shift + kMaxAnglePerSine * turn.vec().norm() * reach_m <= least) return least;
  return std::max(least, shift + motion::rotation_vector(turn).norm() * reach_m);
}

}  // namespace

MotionBounds motion_bounds_of(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                              const motion::Motion& motion) {
  const BoundingBox box = pelvis_bounding_box(motion);
  MotionBounds bounds;
  bounds.pelvis_centre = 0.5F * (box.min + box.max);
  bounds.radius = 0.5F * (box.max - box.min).norm();
  motion::PerBody<motion::CollisionShape> shapes;
  for (const motion::Body body : motion::kBodies)
    shapes[body] = motion::collision_shape_of(model[body].shape);
  const auto places_in = [&](const motion::Pose& pose) {
    return places_of(shapes, forward_kinematics(skeleton, pose));
  };
  motion::PerBody<Place> from = places_in(motion.poses.front());
  double displacement_m = 0;
  for (const motion::Pose& pose : motion.poses) {
    const motion::PerBody<Place> to = places_in(pose);
    for (const motion::Body body : motion::kBodies) {
      displacement_m = max_displacement(from[body], to[body], shapes[body].reach(), displacement_m);
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
