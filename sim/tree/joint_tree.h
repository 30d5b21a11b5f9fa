// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/body_set.h"
#include "sim/figure/figure_rows.h"

namespace flinch::sim {

/// An impulse on a body.
struct BodyImpulse {
  motion::Body body{};
  Twist impulse;
};

/// Spatial inertia of bodies at a point: [mass coupling; coupling^T angular] maps the point's
/// velocity and the angular velocity to impulse and moment.
struct SpatialInertia {
  Eigen::Matrix3d mass, coupling, angular;
};

/// An impulse on bodies, propagated through the joints to the pelvis.
struct PropagatedImpulse {
  BodySet chain = 0;                         ///< the bodies through whose joints it passes
  motion::PerBody<Eigen::Vector3d> moment;   ///< at each of their joints; others are not set
  motion::PerBody<Eigen::Vector3d> angular;  ///< E times the moment
  Eigen::Vector<double, 6> root_impulse,
      root_velocity_change;  ///< at the pelvis, and the velocity change that it causes there
};

/// The equations of motion of a figure's joints over one step, solved by an articulated-body
/// recursion in time proportional to the number of bodies. Solves the same system as ODE's
/// dWorldStep; without the contacts all of its rows are equations and form a tree. joint_tree.cpp
/// has the derivation.
class JointTree {
 public:
  /// `figure_model` must outlive this.
  explicit JointTree(const FigureModel& figure_model);

  /// Sets the step and factors its equations. `impulses` are those of forces on the bodies in
  /// `pushed`; those of others are not read.
  void set_step(const motion::PerBody<BodyState>& now, const FigureRows& rows, double step_s,
                double gravity_mps2, BodySet pushed = 0,
                const motion::PerBody<Twist>& impulses = {});
  /// Propagates impulses, summed, through the joints to the pelvis.
  void propagate(std::span<const BodyImpulse> body_impulses, PropagatedImpulse& propagated) const;
  /// Returns first^T M^-1 second: the velocity change along `second` that `first` causes after the
  /// step. Symmetric in the two.
  static double inverse_inertia_product(const PropagatedImpulse& first,
                                        const PropagatedImpulse& second);
  /// Applies `size` times a propagated impulse to the figure in this step.
  void add(const PropagatedImpulse& propagated, double size);
  /// Computes the velocities after the step, with all added impulses, of the bodies in `wanted`;
  /// those of other bodies are not set. `wanted` must contain the parents of all its bodies.
  void velocities(BodySet wanted, motion::PerBody<Twist>& after) const;

 private:
  using Body = motion::Body;
  struct Link {
    Body parent{};
    BodySet chain = 0;  // the body and all its ancestors
    Eigen::Vector3d joint_local = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_joint;           // from the body's centre of mass, world
    Eigen::Vector3d parent_to_joint;    // from the parent's
    Eigen::Vector3d joint_to_joint;     // from the parent's joint
    Eigen::Matrix3d mobility;           // E
    Eigen::Matrix3d coupling_mobility;  // B E
    Eigen::Matrix3d angular_mobility;   // C E
    Twist prescribed;         // c_0: velocity of the child relative to the parent in the rigid rows
    Eigen::Vector3d angular;  // E b_w + e
  };
  void factor(const JointRows& rows, const motion::PerBody<BodyState>& now, Body body,
              double step_s);
  void anchor(Body body, const AnchorRows& rows, double step_s);

  const FigureModel& figure_model_;
  motion::PerBody<Link> links_;
  // Articulated-body inertia: of each body with all factored descendants, at its joint; of the
  // pelvis at its centre of mass.
  motion::PerBody<SpatialInertia> inertia_;
  motion::PerBody<Twist> momentum_;
  Eigen::Matrix<double, 6, 6>
      root_inverse_inertia_;                // inverse of the whole figure's inertia at the pelvis
  Eigen::Vector<double, 6> root_velocity_;  // of the pelvis, with all added impulses
};

}  // namespace flinch::sim
