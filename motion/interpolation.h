// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "motion/skeleton.h"

namespace flinch::motion {

/// Ease-in ease-out: 3s^2 - 2s^3 of s clamped to [0, 1], so 0 to 1 with no velocity at either end.
float ease_in_ease_out(float s);

/// The way of a human point-to-point movement, 10s^3 - 15s^4 + 6s^5 of s clamped to [0, 1]: the one
/// of least jerk (Flash and Hogan 1985, Journal of Neuroscience 5). As ease_in_ease_out, but with
/// no acceleration at either end.
float minimum_jerk(float s);

/// Spherical interpolation from `from` (weight 0) to `to` (weight 1) along the shorter arc. Unit
/// in, unit out. Nearly parallel rotations are interpolated linearly and normalised.
Eigen::Quaternionf slerp(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to,
                         float weight);

/// Pose between two: the root linearly, every joint by slerp. `weight` 0 is `from`, 1 is `to`.
/// Of `roles` only: the rotations of others are not set.
Pose blend(const Pose& from, const Pose& to, float weight, std::span<const Role> roles = kRoles);

/// One sign for each joint, 1 or -1: q and -q are the same rotation.
using Signs = PerRole<float>;
/// The signs with which the rotations of `to` are on the shorter arcs from those of `from`.
Signs shorter_arcs(const Pose& from, const Pose& to);
/// Changes the signs of those of `roles` whose rotations in `a` and `b` have signs that differ.
void change_signs(const Pose& a, const Pose& b, std::span<const Role> roles, Signs& signs);

/// The same along the arcs that the signs of `to` choose. Where such an arc is nearly a whole turn,
/// which has no direction, the joint takes the shorter one.
Pose blend_along(const Pose& from, const Pose& to, float weight, const Signs& signs,
                 std::span<const Role> roles = kRoles);

/// The same between two poses that move while the weight changes, without the jump to the other
/// side that a joint would make when the shorter arc between its two rotations changes sides: every
/// joint keeps to the arc that is the shorter one between `from_at_start` and `to_at_start`, the
/// poses when the blend begins. At the start it is the same as `blend`.
Pose blend_on_first_arc(const Pose& from, const Pose& to, float weight, const Pose& from_at_start,
                        const Pose& to_at_start);

}  // namespace flinch::motion
