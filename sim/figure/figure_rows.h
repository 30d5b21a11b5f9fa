// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::sim {

/// Strength with which the motors drive a figure to its reference, as shares of the model's
/// stiffness (see scaled_gains).
struct MotorStrength {
  double joints = 1;
  double pelvis = 1;
  double max_pelvis_force_n = std::numeric_limits<double>::infinity();
};

/// Motor equations of the joint between a body and its parent for one step.
struct JointRows {
  Eigen::Vector3d socket = Eigen::Vector3d::Zero();    ///< as in ReferenceState, at the step's end
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rotation axes, columns, world
  std::array<AxisRow, 3> angular;                      ///< relative to the parent
};

/// Motor equations of the pelvis for one step, along and about the world's axes.
struct PelvisRows {
  std::array<AxisRow, 3> linear;
  std::array<AxisRow, 3> angular;
};

/// Returns the equations that take the pelvis from `now` to `target` at the end of a step of
/// `step_s`.
PelvisRows pelvis_rows(const FigureModel& figure_model, const BodyState& now,
                       const BodyState& target, double step_s, const MotorStrength& strength);
/// Returns the equations of a joint. `now` and `parent_now` are the orientations of `body` and its
/// parent.
JointRows joint_rows(const FigureModel& figure_model, motion::Body body,
                     const Eigen::Quaterniond& now, const Eigen::Quaterniond& parent_now,
                     const ReferenceState& target, double step_s, double share);

/// Position of the joint of `body` from its centre of mass, in its own frame, m.
Eigen::Vector3d joint_offset(const FigureModel& figure_model, motion::Body body);

/// A point of a part at which the ground supports it.
struct SupportPoint {
  motion::Body body{};
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< world, m
  double depth_m = 0;                               ///< below the ground's surface
};

/// Support of a foot at its heel and toe: the first `count` of `points`. Where the reference itself
/// sinks a sole into the ground, the ground gives way by that depth, so that an error of the
/// recording does not become a force.
struct FootSupport {
  std::array<SupportPoint, 2> points;
  std::size_t count = 0;
};
FootSupport foot_support(const FigureModel& figure_model, motion::Body foot, const BodyState& now,
                         const BodyState& target);

/// Returns a part's outline at the part's pose, with its velocity.
MovingShape placed_shape(const MovingShape& outline, const BodyState& state);

}  // namespace flinch::sim
