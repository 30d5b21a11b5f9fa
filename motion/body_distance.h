// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::motion {

/// A segment with a radius, world, m.
struct Capsule {
  Eigen::Vector3f from;
  Eigen::Vector3f to;
  float radius = 0;
};

/// A body as a capsule along its longest axis: exact for capsules; of a box, the thickest that
/// its thinnest side holds.
Capsule capsule_of(const Figure& figure, const JointFrames& frames, Body body);

/// Distance of a point from a body's outline, m; 0 inside.
float distance_to(const Figure& figure, const JointFrames& frames, Body body,
                  const Eigen::Vector3f& point);

/// Distance between a capsule and a body's outline, m, exact to 1e-5; negative, down to the
/// capsule's radius, where they overlap.
float distance_between(const Figure& figure, const JointFrames& frames, Body body,
                       const Capsule& capsule);

/// Distance of a point from the nearest body, m.
float distance_to_figure(const Figure& figure, const JointFrames& frames,
                         const Eigen::Vector3f& point);

/// How far along `direction` (unit) the line from `point` leaves head, trunk and pelvis for good,
/// m; 0 where it meets none of them ahead. A capsule counts as its bounding box.
float clearance_along(const Figure& figure, const JointFrames& frames, const Eigen::Vector3f& point,
                      const Eigen::Vector3f& direction);

/// Head, neck, chest, abdomen and pelvis: what hands protect and may not pass through.
inline constexpr std::array<Body, 5> kCoreBodies{Body::head, Body::neck, Body::chest, Body::abdomen,
                                                 Body::pelvis};

}  // namespace flinch::motion
