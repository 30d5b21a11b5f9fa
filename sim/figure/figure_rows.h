// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::sim {

/// How hard a figure is driven to its reference: shares of the plan's stiffness (see scaled_gains).
struct MotorStrength {
  double joints = 1;
  double pelvis = 1;
  double max_pelvis_force_n = std::numeric_limits<double>::infinity();
};

/// What a step asks of the joint between a body and its parent.
struct JointRows {
  Eigen::Vector3d socket = Eigen::Vector3d::Zero();    ///< ReferenceState's, by the step's end
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of the turning, columns, world
  std::array<AxisRow, 3> angular;                      ///< relative to the parent
};

/// What a step asks of the pelvis, along and about the world's axes.
struct PelvisRows {
  std::array<AxisRow, 3> linear;
  std::array<AxisRow, 3> angular;
};

/// The rows by which `target` is wanted at the end of a step of `step_s` from `now`.
PelvisRows pelvis_rows(const FigureModel& figure_model, const BodyState& now,
                       const BodyState& target, double step_s, const MotorStrength& strength);
/// `now` and `parent_now` are the orientations of `body` and its parent.
JointRows joint_rows(const FigureModel& figure_model, motion::Body body,
                     const Eigen::Quaterniond& now, const Eigen::Quaterniond& parent_now,
                     const ReferenceState& target, double step_s, double share);

/// The joint of `body` from its centre of mass, in its own frame, m.
Eigen::Vector3d joint_offset(const FigureModel& figure_model, motion::Body body);

/// A part's point that the ground carries.
struct SupportPoint {
  motion::Body body{};
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< world, m
  double depth_m = 0;                               ///< below the ground that carries it
};

/// Heel and toe of a foot, at most two of which the ground carries: `count` of `points`. Where the
/// reference itself sinks a sole into the ground, the ground gives way that far: a fault of the
/// recording must not become a force.
struct FootSupport {
  std::array<SupportPoint, 2> points;
  std::size_t count = 0;
};
FootSupport foot_support(const FigureModel& figure_model, motion::Body foot, const BodyState& now,
                         const BodyState& target);

/// A part's outline where the part is, as it moves.
MovingShape placed_shape(const MovingShape& outline, const BodyState& state);

}  // namespace flinch::sim
