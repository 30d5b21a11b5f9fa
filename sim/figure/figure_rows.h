// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "sim/figure/drive.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::sim {

/// Motor equations of the joint between a body and its parent for one step.
struct JointRows {
  Eigen::Vector3d socket = Eigen::Vector3d::Zero();    ///< as in ReferenceState, at the step's end
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rotation axes, columns, world
  std::array<AxisRow, 3> angular;                      ///< relative to the parent
};

/// Equations of springs from a body to the world for one step, along and about the world's axes, at
/// the body's centre of mass.
struct AnchorRows {
  std::array<AxisRow, 3> linear;
  std::array<AxisRow, 3> angular;
};

/// Returns the equations that take the pelvis from `now` to `target` at the end of a step of
/// `step_s`.
AnchorRows pelvis_rows(const FigureModel& figure_model, const BodyState& now,
                       const BodyState& target, double step_s, const MotorStrength& strength);
/// Returns the equations of a joint. `now` and `parent_now` are the orientations of `body` and its
/// parent.
JointRows joint_rows(const FigureModel& figure_model, motion::Body body,
                     const Eigen::Quaterniond& now, const Eigen::Quaterniond& parent_now,
                     const ReferenceState& target, double step_s, double share);

/// The springs between a figure and the world in a step.
struct FigureAnchors {
  std::optional<AnchorRows> pelvis;                 ///< unless it is free
  motion::PerSide<std::optional<AnchorRows>> feet;  ///< that are held in place
};
FigureAnchors figure_anchors(const FigureModel& figure_model, const motion::PerBody<BodyState>& now,
                             const ReferenceState& target, double step_s, const Drive& drive);

/// All equations of a figure for a step, except its contacts.
struct FigureRows : FigureAnchors {
  motion::PerBody<JointRows> joints;  ///< the pelvis has none
};
FigureRows figure_rows(const FigureModel& figure_model, const motion::PerBody<BodyState>& now,
                       const ReferenceState& target, double step_s, const Drive& drive);

/// Returns a part's outline at the part's pose, with its velocity.
MovingShape placed_shape(const MovingShape& outline, const BodyState& state);

}  // namespace flinch::sim
