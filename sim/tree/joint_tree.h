// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/body_set.h"
#include "sim/figure/figure_rows.h"

namespace flinch::sim {

/// Velocities of a body at its centre of mass, m/s and rad/s; or an impulse and its moment there,
/// N·s and N·m·s. World.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};

/// All that a step asks of a figure but for its contacts.
struct FigureRows {
  PelvisRows pelvis;
  motion::PerBody<JointRows> joints;  ///< the pelvis has none
};
FigureRows figure_rows(const FigureModel& figure_model, const motion::PerBody<BodyState>& now,
                       const ReferenceState& target, double step_s);

/// An impulse on a body.
struct BodyImpulse {
  motion::Body body{};
  Twist impulse;
};

/// The inertia of bodies at a point: [mass coupling; coupling^T angular] takes the velocities of
/// the point and about it to impulse and moment.
struct SpatialInertia {
  Eigen::Matrix3d mass, coupling, angular;
};

/// An impulse as the joints pass it on to the pelvis.
struct PropagatedImpulse {
  BodySet chain = 0;                         ///< the bodies by whose joints it passes
  motion::PerBody<Eigen::Vector3d> moment;   ///< at the joint of each; others are not set
  motion::PerBody<Eigen::Vector3d> angular;  ///< E times that
  Eigen::Vector<double, 6> root_impulse,
      root_velocity_change;  ///< at the pelvis, and what it does there
};

/// The equations of motion of a figure's joints over one step, solved in time proportional to its
/// bodies: what ODE's dWorldStep solves, whose rows are all equations and form a tree but for the
/// contacts; joint_tree.cpp derives it.
class JointTree {
 public:
  /// `figure_model` must outlive this.
  explicit JointTree(const FigureModel& figure_model);

  /// Sets the step and factors its equations.
  void set_step(const motion::PerBody<BodyState>& now, const FigureRows& rows, double step_s,
                double gravity_mps2);
  /// How loads, whose impulses add up, are passed on in the step.
  void propagate(std::span<const BodyImpulse> body_impulses, PropagatedImpulse& propagated) const;
  /// By how much `first` changes the velocity along `second` after the step, and the other way
  /// round: first^T M^-1 second.
  static double inverse_inertia_product(const PropagatedImpulse& first,
                                        const PropagatedImpulse& second);
  /// Gives the figure `size` times an impulse in the step.
  void add(const PropagatedImpulse& propagated, double size);
  /// The velocities after the step of the bodies in `wanted`, with all that was added; those of
  /// others are not set. `wanted` must contain the parents of all that it contains.
  void velocities(BodySet wanted, motion::PerBody<Twist>& after) const;

 private:
  using Body = motion::Body;
  struct Link {
    Body parent{};
    BodySet chain = 0;  // the body and all that carry it
    Eigen::Vector3d joint_local = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_joint;           // from the body's centre of mass, world
    Eigen::Vector3d parent_to_joint;    // from the parent's
    Eigen::Vector3d joint_to_joint;     // from the parent's joint
    Eigen::Matrix3d mobility;           // E
    Eigen::Matrix3d coupling_mobility;  // B E
    Eigen::Matrix3d angular_mobility;   // C E
    Twist prescribed;         // c_0: what the rigid rows ask of the child against its parent
    Eigen::Vector3d angular;  // E b_w + e
  };
  void factor(const JointRows& rows, const motion::PerBody<BodyState>& now, Body body,
              double step_s);
  void factor_root(const PelvisRows& rows, double step_s);

  const FigureModel& figure_model_;
  motion::PerBody<Link> links_;
  // Of the bodies and, as far as they are factored, of all beyond them; at their joints, or the
  // pelvis' centre of mass.
  motion::PerBody<SpatialInertia> inertia_;
  motion::PerBody<Twist> momentum_;
  Eigen::Matrix<double, 6, 6>
      root_inverse_inertia_;                // inverse of the whole figure's inertia at the pelvis
  Eigen::Vector<double, 6> root_velocity_;  // of the pelvis, with all that was added
};

}  // namespace flinch::sim
