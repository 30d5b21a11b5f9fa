// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "motion/foot.h"
#include "motion/skin/control_cage.h"

namespace flinch::motion {

/// What the cages of the parts are shaped after.
struct CageGuide {
  const Physique& character;
  BodyModel bodies;
  JointFrames rest;

  const Eigen::Vector3f& joint(Role role) const { return rest.position[role]; }
};

/// Returns the role of the right side for a role of the left side, if `side` is right.
Role role_on(Side side, Role left);

/// The rings at which the parts of a figure meet.
struct TrunkEnds {
  Ring neck;           ///< 12 vertices: front, left, back, right
  PerSide<Ring> arms;  ///< 8 vertices: front, up, back, down
  PerSide<Ring> legs;  ///< 8 vertices: front, outward, back, inward
};

/// Adds the trunk, from hips to the neck, open where the other parts begin.
TrunkEnds add_trunk(const CageGuide& guide, CageBuilder& builder);
/// Adds the head, which closes the neck.
void add_head(const CageGuide& guide, const Ring& neck, CageBuilder& builder);
/// Adds an arm with its hand, which closes the hole of the shoulder.
void add_arm(const CageGuide& guide, Side side, const Ring& shoulder, CageBuilder& builder);
/// Adds a leg with its foot, which closes the hole of the hip.
void add_leg(const CageGuide& guide, Side side, const Ring& hip, CageBuilder& builder);

}  // namespace flinch::motion
