// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::motion {

/// A segment with a radius: a cylinder with round caps. World, m.
struct Capsule {
  Eigen::Vector3f from;
  Eigen::Vector3f to;
  float radius = 0;
};

/// Returns a capsule along the body's longest axis: exact for capsules; for a box, the thickest one
/// that fits inside it.
Capsule capsule_of(const Figure& figure, const JointFrames& frames, Body body);

/// Distance between a point and a body's outline, m; 0 inside.
float distance_to(const Figure& figure, const JointFrames& frames, Body body,
                  const Eigen::Vector3f& point);

/// Distance between a capsule and a body's outline, m, exact to 1e-5. Negative where they overlap,
/// but never below minus the capsule's radius.
float distance_between(const Figure& figure, const JointFrames& frames, Body body,
                       const Capsule& capsule);

/// Distance between a point and the nearest body, m.
float distance_to_figure(const Figure& figure, const JointFrames& frames,
                         const Eigen::Vector3f& point);

/// Distance along `direction` (unit) from `point` to where the ray last leaves head, trunk and
/// pelvis, m; 0 where it meets none of them. A capsule counts as its bounding box.
float clearance_along(const Figure& figure, const JointFrames& frames, const Eigen::Vector3f& point,
                      const Eigen::Vector3f& direction);

/// Head, neck, chest, abdomen and pelvis: what hands protect and must not pass through.
inline constexpr std::array<Body, 5> kCoreBodies{Body::head, Body::neck, Body::chest, Body::abdomen,
                                                 Body::pelvis};

}  // namespace flinch::motion
