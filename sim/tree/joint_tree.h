// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/body_set.h"
#include "sim/figure/figure_rows.h"
#include "sim/tree/tree_lanes.h"

namespace flinch::sim {

/// An impulse on a body.
struct BodyImpulse {
  motion::Body body{};
  Twist impulse;
};

/// A step of one figure.
struct TreeStep {
  const motion::PerBody<BodyState>& now;
  const ReferenceState& target;  ///< the reference at the end of the step
  double step_s = 0;
  double gravity_mps2 = 0;
  const Drive& drive;
  BodySet pushed = 0;                      ///< the bodies on which forces act
  const motion::PerBody<Twist>& impulses;  ///< of these forces; others are not read
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
/// dWorldStep; without the contacts all of its rows are equations and form a tree. factor_trees.h
/// has the derivation, and TreeLanes the equations.
class JointTree {
 public:
  /// `figure_model` must outlive this.
  explicit JointTree(const FigureModel& figure_model);

  /// Writes a step into a lane, for factor_trees().
  template <std::size_t kLanes>
  void put_step(const TreeStep& step, TreeLanes<kLanes>& lanes, std::size_t lane) const;
  /// Takes over the equations that factor_trees() has factored in a lane.
  template <std::size_t kLanes>
  void take_factors(const TreeLanes<kLanes>& lanes, std::size_t lane);
  /// Writes the added impulses into the lane, for move_figures().
  template <std::size_t kLanes>
  void put_impulses(TreeLanes<kLanes>& lanes, std::size_t lane) const;
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
    BodySet chain = 0;                  // the body and all its ancestors
    Eigen::Vector3d to_joint;           // from the body's centre of mass, world
    Eigen::Vector3d parent_to_joint;    // from the parent's
    Eigen::Vector3d joint_to_joint;     // from the parent's joint
    Eigen::Matrix3d mobility;           // E
    Eigen::Matrix3d coupling_mobility;  // B E
    Eigen::Matrix3d angular_mobility;   // C E
    Twist prescribed;         // c_0: velocity of the child relative to the parent in the rigid rows
    Eigen::Vector3d angular;  // E b_w + e
  };

  const FigureModel& figure_model_;
  motion::PerBody<Link> links_;
  Eigen::Matrix<double, 6, 6>
      root_inverse_inertia_;                // inverse of the whole figure's inertia at the pelvis
  Eigen::Vector<double, 6> root_velocity_;  // of the pelvis, with all added impulses
};

}  // namespace flinch::sim
