// SPDX-License-Identifier: MIT
#include "evolve/trial/joint_effort.h"

#include <algorithm>

#include "sim/figure/figure_model.h"
#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::evolve {
namespace {

using Eigen::Vector3d;
using motion::Body;
using sim::BodyState;

/// L = R I R^T w
Vector3d angular_momentum(const Eigen::Matrix3d& inertia, const BodyState& state) {
  const Vector3d local = state.orientation.conjugate() * state.angular_velocity;
  return state.orientation * (inertia * local);
}

/// The axis about which the muscles of the back of the hand turn it, world; zero for other joints.
/// In the rest pose palms face down, and the left hand points to the left.
Vector3d extension_axis(Body joint, const motion::PerBody<BodyState>& bodies) {
  if (joint == Body::left_hand) return bodies[Body::left_forearm].orientation * Vector3d::UnitX();
  if (joint == Body::right_hand)
    return bodies[Body::right_forearm].orientation * -Vector3d::UnitX();
  return Vector3d::Zero();
}

}  // namespace

// The angular impulse at joint j in a step is the change of angular momentum about it of all bodies
// i beyond it, less that of gravity,
//
//   tau_j h = sum_i L_i' - L_i + (c_i - p_j) x (m_i (v_i' - v_i) + m_i g h z),
//
// with c_i and p_j at the step's start. Bodies are stored parents first, so a pass from the last to
// the first sums up what is beyond each joint: the linear impulses F and their moment about the
// world's origin M, of which the moment about p is M - p x F.
double joint_effort(const sim::FigureModel& figure_model, const sim::Rehearsal& rehearsal,
                    double gravity_mps2, double extension_weight) {
  const sim::Rehearsal::Track& track = rehearsal.track();
  double effort = 0;
  for (std::size_t step = track.first_kept; step + 1 < track.first_kept + track.figures.size();
       ++step) {
    const motion::PerBody<BodyState>& from = track.figure_at(step);
    const motion::PerBody<BodyState>& to = track.figure_at(step + 1);
    const Vector3d weight(0, 0, gravity_mps2 * track.step_s(step));
    motion::PerBody<Vector3d> force;
    motion::PerBody<Vector3d> moment;
    for (const Body body : motion::kBodies) {
      const auto mass_kg = static_cast<double>(figure_model.model[body].mass_kg);
      const Eigen::Matrix3d& inertia = figure_model.inertia[body];
      force[body] = mass_kg * (to[body].velocity - from[body].velocity + weight);
      moment[body] = angular_momentum(inertia, to[body]) - angular_momentum(inertia, from[body]) +
                     from[body].position.cross(force[body]);
    }
    for (std::size_t k = motion::kBodyCount - 1; k > 0; --k) {
      const Body body = motion::kBodies[k];
      const Body parent = *parent_of(body);
      force[parent] += force[body];
      moment[parent] += moment[body];
    }
    for (const Body joint : kEffortJoints) {
      const Vector3d pivot =
          from[joint].position + from[joint].orientation * joint_offset(figure_model, joint);
      const Vector3d torque = moment[joint] - pivot.cross(force[joint]);
      effort += torque.norm();
      if (extension_weight > 0)
        effort += extension_weight * std::max(torque.dot(extension_axis(joint, from)), 0.0);
    }
  }
  return effort;
}

}  // namespace flinch::evolve
