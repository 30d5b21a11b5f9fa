// SPDX-License-Identifier: MIT
#pragma once

#include "features/threat.h"
#include "motion/collision_shape.h"
#include "sim/body_state.h"

namespace flinch::sim {

/// A ball that is slower than this does not bounce, m/s.
inline constexpr double kMinBounceSpeed_mps = 0.2;
/// Surfaces that pass each other more slowly than this do not slide, m/s: half a micrometre per
/// contact step.
inline constexpr double kMinSlidingSpeed_mps = 1e-3;

/// A contact between two things at a point during one step, and its law. Velocities are those of
/// first less second, along the normal (n) and across it (t), after the step, and obey with forces
/// f
///
///     v_n + softness f_n >= max(v_0, -bounce v_n before it),   f_n >= 0,
///     v_0 = error_reduction depth_m / h - free_closing_mps,
///     |f_t| <= friction f_n of a step without friction, for t = tangent and t = normal x tangent.
///
/// v_0 corrects an overlap. Below kMinBounceSpeed_mps there is no bounce. The bounds of friction
/// are a square, which allows more across its corners than across its sides. With `tangent` along
/// the velocity of sliding, friction meets a side, whatever that direction is in the world.
struct ContactConstraint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< world, m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from second to first
  /// Unit, across the normal. Of no effect without friction.
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();
  double depth_m = 0;
  double error_reduction = 0;
  double softness = 1e-10;  ///< m/s/N; above 0 so that duplicate rows stay solvable
  double restitution = 0;
  double friction = 0;
  double free_closing_mps = 0;
};

/// Contact of the ball with a part: a rigid bounce that returns `bounce.restitution` times the
/// relative normal velocity, with Coulomb friction and without correction of overlap. `normal`
/// points to the ball. Where the two do not slide, the tangent is fixed to the part.
ContactConstraint impact_constraint(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                    const BodyState& ball, const BodyState& part,
                                    const features::Bounce& bounce);
/// The same with the ground. Where the ball does not slide, the tangent turns with `frame`, the
/// orientation of something that turns with the scene.
ContactConstraint bounce_constraint(const BodyState& ball, const Eigen::Quaterniond& frame,
                                    const features::Bounce& bounce);
/// Contact of two parts: no bounce, no friction, no correction of overlap; the parts may close at
/// up to `free_closing_mps` without resistance.
ContactConstraint body_contact_constraint(const motion::Clearance& at, double free_closing_mps);
/// Contact of a part with the ground, which carries `mass_kg` at `point`, `depth_m` below it, as a
/// critically damped spring without friction.
ContactConstraint ground_constraint(const Eigen::Vector3d& point, double depth_m, double mass_kg,
                                    double step_s);

}  // namespace flinch::sim
