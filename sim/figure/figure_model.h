// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "sim/body_set.h"
#include "sim/collision/sweep.h"
#include "sim/figure/joint_range.h"
#include "sim/figure/springs.h"
#include "sim/figure/tree_constants.h"

namespace flinch::sim {

/// Constants of a simulated figure: everything that does not change between simulations.
struct FigureModel {
  explicit FigureModel(const motion::Physique& character, BodySet met_by_ball = kAllBodies);

  motion::Skeleton skeleton;
  motion::BodyModel model;
  motion::PerBody<MovingShape> outline;    ///< in the frame of the centre of mass, in the rest pose
  motion::PerBody<double> outline_radius;  ///< of the outline's bounding sphere about its centre, m
  motion::PerBody<double> radius;          ///< of the bounding sphere about the centre of mass, m
  motion::PerBody<Eigen::Matrix3d> inertia;  ///< about the centre of mass, kg·m²
  motion::PerBody<Gains> gains;  ///< of the joint to the parent; pelvis: of its rotation
  Gains pelvis_gains;            ///< of the pelvis' position
  double mass_kg = 0;            ///< of the whole figure
  motion::PerBody<JointKind> kinds;
  motion::PerBody<JointRange> limits;
  /// Bodies that can collide with each body: neither connected by a joint nor overlapping in the
  /// rest pose.
  motion::PerBody<BodySet> may_collide;
  TreeConstants tree;  ///< the same, for TreeLanes
  BodySet ball_meets;  ///< the ball passes through other bodies
};

/// Position of the joint of `body` from its centre of mass, in its own frame, m.
Eigen::Vector3d joint_offset(const FigureModel& figure_model, motion::Body body);

/// A point on the underside of a foot's box, in the frame of the foot's centre of mass, m.
/// `forward` and `left` are in [-1, 1] across the box.
Eigen::Vector3d sole_point(const MovingShape& foot, double forward, double left);

}  // namespace flinch::sim
