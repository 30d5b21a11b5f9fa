// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::features {

/// A body's outline for contact, in double and wherever it is.
struct Outline {
  motion::Shape::Kind kind = motion::Shape::Kind::capsule;
  double radius = 0;                                                ///< of a capsule, m
  double half_length = 0;                                           ///< of a capsule, m
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();           ///< of a box, m
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();                 ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit

  /// How far the farthest point that can touch is moved by a turn about the centre, m.
  double reach() const;
};

/// In the frame of the shape: of its body's joint.
Outline outline_of(const motion::Shape& shape);

/// That of one body where the figure's joints are, world.
Outline outline_of(const motion::BodyModel& model, const motion::JointFrames& frames,
                   motion::Body body);
/// Those of all its bodies.
motion::PerBody<Outline> outlines_of(const motion::BodyModel& model,
                                     const motion::JointFrames& frames);

/// Where a ball and an outline are closest.
struct Clearance {
  double gap = 0;                                     ///< m, negative where they overlap
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< on the outline's surface
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from the outline to the ball
};

/// How near a ball is to an outline.
Clearance clearance(const Eigen::Vector3d& ball_centre, double ball_radius, const Outline& outline);
/// Its gap alone, the same bits in half the time.
double gap(const Eigen::Vector3d& ball_centre, double ball_radius, const Outline& outline);

}  // namespace flinch::features
