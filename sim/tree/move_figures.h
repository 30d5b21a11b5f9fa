// SPDX-License-Identifier: MIT
// The source of move_figures(), included once by a file per instruction set; see lane_algebra.h.
#pragma once

#include "sim/tree/row_lanes.h"

namespace flinch::sim {
namespace {

// x' = x + h v, and q' is q + h/2 w q normalised.
template <std::size_t kLanes>
void move_body(const Vector<Number<kLanes>>& velocity,
               const Vector<Number<kLanes>>& angular_velocity, const Number<kLanes>& step_s,
               typename TreeLanes<kLanes>::Body& body) {
  using N = Number<kLanes>;
  store(load(body.position) + step_s * velocity, body.position);
  store(velocity, body.velocity);
  store(angular_velocity, body.angular_velocity);
  const Quaternion<N> before = load(body.orientation);
  const N half = 0.5 * step_s;
  const Quaternion<N> turned{
      before.w - half * dot(angular_velocity, before.u),
      before.u + half * (before.w * angular_velocity + cross(angular_velocity, before.u))};
  const N share = 1.0 / square_root(turned.w * turned.w + dot(turned.u, turned.u));
  store(Quaternion<N>{share * turned.w, share * turned.u}, body.orientation);
}

// The second pass of factor_lanes(), from the root to the leaves.
template <std::size_t kLanes>
void move_lanes(const TreeConstants& constants, TreeLanes<kLanes>& lanes) {
  using N = Number<kLanes>;
  const N step_s = load(lanes.step_s);
  Vector<N> linear[TreeConstants::kBodies];
  Vector<N> angular[TreeConstants::kBodies];
  const auto& root = lanes.root_velocity;
  linear[0] = {load(root[0]), load(root[1]), load(root[2])};
  angular[0] = {load(root[3]), load(root[4]), load(root[5])};
  move_body<kLanes>(linear[0], angular[0], step_s, lanes.bodies[0]);
  for (std::size_t body = 1; body < TreeConstants::kBodies; ++body) {
    const auto& link = lanes.links[body];
    const std::size_t parent = constants.bodies[body].parent;
    const Vector<N> at_joint = linear[parent] + cross(angular[parent], load(link.parent_to_joint));
    angular[body] = angular[parent] + load(link.prescribed_angular) + load(link.angular) -
                    transposed_times(load(link.coupling_mobility), at_joint) -
                    transposed_times(load(link.angular_mobility), angular[parent]);
    linear[body] = at_joint + load(link.prescribed) + cross(load(link.to_joint), angular[body]);
    move_body<kLanes>(linear[body], angular[body], step_s, lanes.bodies[body]);
  }
}

}  // namespace
}  // namespace flinch::sim
