// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "sim/body_set.h"
#include "sim/collision/sweep.h"
#include "sim/figure/joint_range.h"
#include "sim/figure/springs.h"
#include "sim/figure/tree_constants.h"
#include "sim/simulation_options.h"

namespace flinch::sim {

/// What a joint's springs do besides tracking with their gains.
struct ServoLaw {
  /// Whether the damper acts on the difference to the reference's velocity, or on the velocity.
  bool follows_velocity = true;
  double twist_share = 1;      ///< share of the torque about the bone's axis that is left
  double limit_stiffness = 0;  ///< added to the gains beyond a limit, N·m/rad
  double limit_damping = 0;    ///< N·m·s/rad
};

/// Constants of a simulated figure: everything that does not change between simulations.
struct FigureModel {
  explicit FigureModel(const motion::Physique& character, const SimulationOptions& options = {});

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
  motion::PerBody<Eigen::Vector3d> hinge;  ///< anatomical axis in the parent's frame, or zero
  motion::PerBody<JointRange> limits;
  motion::PerBody<ServoLaw> laws;
  /// Bodies that can collide with each body: neither connected by a joint nor overlapping in the
  /// rest pose.
  motion::PerBody<BodySet> may_collide;
  TreeConstants tree;  ///< the same, for TreeLanes
  BodySet ball_meets;  ///< the ball passes through other bodies
};

/// Inertia that a joint carries in the rest pose, of all bodies beyond it about the joint,
///   I = sum tr(I_i)/3 + m_i |c_i - p|^2, kg·m².
double composite_inertia(const FigureModel& figure_model, const motion::JointFrames& rest,
                         motion::Body joint);

/// The same numbers for TreeLanes.
TreeConstants tree_constants(const FigureModel& figure_model);

/// Whether a joint's springs have axes along and across the bone as it is: others have the parent's
/// or a hinge's.
bool has_bone_axes(const FigureModel& figure_model, motion::Body body);
/// Index of the coordinate axis that a joint's bone is along.
int bone_index(const JointRange& limits);

/// Position of the joint of `body` from its centre of mass, in its own frame, m.
Eigen::Vector3d joint_offset(const FigureModel& figure_model, motion::Body body);

/// A point on the underside of a foot's box, in the frame of the foot's centre of mass, m.
/// `forward` and `left` are in [-1, 1] across the box.
Eigen::Vector3d sole_point(const MovingShape& foot, double forward, double left);

}  // namespace flinch::sim
