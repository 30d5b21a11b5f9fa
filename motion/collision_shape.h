// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::motion {

/// A body's outline for contact, in double precision, in any frame.
struct CollisionShape {
  Shape::Kind kind = Shape::Kind::capsule;
  double radius = 0;                                                ///< of a capsule, m
  double half_length = 0;                                           ///< of a capsule, m
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();           ///< of a box, m
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();                 ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit

  /// Largest displacement of the surface per radian of rotation about the centre, m.
  double reach() const;
};

/// Returns the shape in the frame of its body's joint.
CollisionShape collision_shape_of(const Shape& shape);

/// Returns the shape of one body of a figure with these joint frames, world.
CollisionShape collision_shape_of(const BodyModel& model, const JointFrames& frames, Body body);
/// Returns the shapes of all bodies of a figure with these joint frames, world.
PerBody<CollisionShape> collision_shapes_of(const BodyModel& model, const JointFrames& frames);

/// The closest points of a ball and an outline.
struct Clearance {
  double gap = 0;                                     ///< m, negative where they overlap
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< on the outline's surface
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from the outline to the ball
};

/// Returns the gap between a ball and an outline, with the closest point and the normal.
Clearance clearance(const Eigen::Vector3d& ball_centre, double ball_radius,
                    const CollisionShape& outline);
/// Returns how far along the segment from `from` to `to`, from 0 to 1, a ball is nearest to an
/// outline; where the segment passes through a box, the deepest place. In closed form, in the time
/// of a few clearances.
double nearest_share(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     const CollisionShape& outline);
/// Returns only the gap of clearance(), to the same bits, in half the time.
double gap(const Eigen::Vector3d& ball_centre, double ball_radius, const CollisionShape& outline);

}  // namespace flinch::motion
