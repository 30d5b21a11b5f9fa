// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "sim/body_set.h"
#include "sim/collision/sweep.h"
#include "sim/figure/joint_range.h"
#include "sim/figure/springs.h"

namespace flinch::sim {

/// What a figure is made of: all that does not change from one simulation to the next.
struct FigureModel {
  explicit FigureModel(const motion::Physique& character);

  motion::Skeleton skeleton;
  motion::BodyModel model;
  motion::PerBody<MovingShape> outline;      ///< in the frame of the centre of mass, at rest
  motion::PerBody<double> outline_radius;    ///< of the sphere about its centre that holds it, m
  motion::PerBody<double> radius;            ///< of that about the centre of mass, m
  motion::PerBody<Eigen::Matrix3d> inertia;  ///< about the centre of mass, kg·m²
  motion::PerBody<Gains> gains;              ///< of the joint to the parent; pelvis: its turning
  Gains pelvis_gains;                        ///< of the pelvis' place
  double mass_kg = 0;                        ///< of the whole figure
  motion::PerBody<JointKind> kinds;
  motion::PerBody<JointRange> limits;
  /// Pairs that can push each other: neither jointed nor overlapping in the rest pose.
  motion::PerBody<BodySet> may_collide;
};

/// A point of the underside of a foot's box, in the frame of the foot's centre of mass, m:
/// `forward` and `left` go from -1 to 1 across the box.
Eigen::Vector3d sole_point(const MovingShape& foot, double forward, double left);

}  // namespace flinch::sim
