// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "motion/skeleton.h"

namespace flinch::motion {

/// Ease-in ease-out: 3s^2 - 2s^3 of s clamped to [0, 1]. Goes from 0 to 1 with zero velocity at
/// both ends.
float ease_in_ease_out(float s);

/// Minimum-jerk profile of a human point-to-point movement, 10s^3 - 15s^4 + 6s^5 with s clamped to
/// [0, 1] (Flash and Hogan 1985, Journal of Neuroscience 5). Like ease_in_ease_out, but with zero
/// acceleration at both ends.
float minimum_jerk(float s);

/// Spherical interpolation from `from` (weight 0) to `to` (weight 1) along the shorter arc. Takes
/// and returns unit quaternions. Nearly parallel rotations are interpolated linearly and
/// normalised.
Eigen::Quaternionf slerp(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to,
                         float weight);

/// Interpolates between two poses: the root linearly, every joint by slerp. Weight 0 gives `from`,
/// 1 gives `to`. Only `roles` are blended; the rotations of other roles are not set.
Pose blend(const Pose& from, const Pose& to, float weight, std::span<const Role> roles = kRoles);

/// One sign per joint, 1 or -1: q and -q are the same rotation.
using Signs = PerRole<float>;
/// Returns the signs that put the rotations of `to` on the shorter arcs from those of `from`.
Signs shorter_arcs(const Pose& from, const Pose& to);
/// Inverts the signs of those `roles` whose rotations are on the shorter arcs from `a` to `b` with
/// the other sign.
void change_signs(const Pose& a, const Pose& b, std::span<const Role> roles, Signs& signs);

/// Like blend(), along the arcs that the signs of `to` select. Where such an arc is nearly a whole
/// turn, its direction is undefined and the joint takes the shorter arc.
Pose blend_along(const Pose& from, const Pose& to, float weight, const Signs& signs,
                 std::span<const Role> roles = kRoles);

/// Like blend(), for two poses that move while the weight changes. When the shorter arc between a
/// joint's two rotations changes sides, blend() would jump; here every joint keeps the arc that is
/// the shorter one between `from_at_start` and `to_at_start`, the poses when the blend begins. At
/// the start of the blend the result equals blend().
Pose blend_along_initial_arc(const Pose& from, const Pose& to, float weight,
                             const Pose& from_at_start, const Pose& to_at_start);

}  // namespace flinch::motion
