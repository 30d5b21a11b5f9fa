// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "sim/figure_rows.h"

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
FigureRows figure_rows(const FigurePlan& plan, const motion::PerBody<BodyState>& now,
                       const ReferenceState& target, double step_s);

/// An impulse on a body.
struct Load {
  motion::Body body{};
  Twist impulse;
};

/// A set of bodies, one bit each.
using BodySet = std::uint32_t;
constexpr BodySet set_of(motion::Body body) {
  return BodySet{1} << static_cast<unsigned>(body);
}

/// The equations of motion of a figure's joints over one step, solved in time proportional to its
/// bodies: what ODE's dWorldStep solves, whose rows are all equations and form a tree but for the
/// contacts; joint_tree.cpp derives it.
class JointTree {
 public:
  /// `plan` must outlive this.
  explicit JointTree(const FigurePlan& plan);

  /// Sets the step and factors its equations.
  void set_step(const motion::PerBody<BodyState>& now, const FigureRows& rows, double step_s,
                double gravity_mps2);
  /// The velocities after the step, with contacts' impulses on the bodies.
  motion::PerBody<Twist> velocities(const motion::PerBody<Twist>& impulses) const;
  /// By how much loads change the velocities after the step of the bodies in `wanted`; those of
  /// others are not set. `wanted` must contain the parents of all that it contains.
  void response(std::span<const Load> loads, BodySet wanted, motion::PerBody<Twist>& change) const;
  /// A body and all that carry it.
  BodySet chain_to(motion::Body body) const { return links_[body].chain; }

 private:
  using Body = motion::Body;
  struct Link {
    Body parent{};
    BodySet chain = 0;
    Eigen::Vector3d joint_local = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_joint;         // from the body's centre of mass, world
    Eigen::Vector3d parent_to_joint;  // from the parent's
    // The inertia of the body and all beyond it, moved at the joint: [A B; B^T C].
    Eigen::Matrix3d mass, coupling, inertia;
    Eigen::Matrix3d give;           // E
    Eigen::Matrix3d coupling_give;  // B E
    Eigen::Matrix3d inertia_give;   // C E
    Eigen::Vector3d driven;         // e
    Twist forced;                   // c_0: what the rigid rows ask of the child against its parent
    Twist forced_impulse;           // N c_0 + U e
  };
  static void set_give(const JointRows& rows, double step_s, Link& link);
  void factor(const JointRows& rows, const motion::PerBody<BodyState>& now, Body body,
              double step_s);
  void add_to_parent(Link& link);
  static Twist carried(const Link& link, const Twist& at_joint);

  const FigurePlan& plan_;
  motion::PerBody<Link> links_;
  motion::PerBody<Eigen::Matrix3d> mass_, coupling_, inertia_;  // at the centres of mass
  motion::PerBody<Twist> momentum_;                             // before contacts and joints
  Eigen::Matrix<double, 6, 6> root_;  // inverse of the whole figure's inertia at the pelvis
};

}  // namespace flinch::sim
