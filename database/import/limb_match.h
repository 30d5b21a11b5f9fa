// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "database/import/joint_tree.h"
#include "database/import/role_map.h"
#include "database/import/role_names.h"

namespace flinch::database {

/// The roles of one limb, from the trunk outwards.
using LimbRoles = std::array<motion::Role, 4>;
inline constexpr LimbRoles kLeftArm{motion::Role::left_clavicle, motion::Role::left_upper_arm,
                                    motion::Role::left_forearm, motion::Role::left_hand};
inline constexpr LimbRoles kRightArm{motion::Role::right_clavicle, motion::Role::right_upper_arm,
                                     motion::Role::right_forearm, motion::Role::right_hand};
inline constexpr LimbRoles kLeftLeg{motion::Role::left_thigh, motion::Role::left_shin,
                                    motion::Role::left_foot, motion::Role::left_toes};
inline constexpr LimbRoles kRightLeg{motion::Role::right_thigh, motion::Role::right_shin,
                                     motion::Role::right_foot, motion::Role::right_toes};

/// The joints of one limb, each hanging from the one before.
struct LimbMatch {
  std::array<int, 4> joint{kNoJoint, kNoJoint, kNoJoint, kNoJoint};
  std::array<RoleSource, 4> source{};  ///< none where the limb has no such joint
  double score = 0;                    ///< the higher, the better do names and lengths fit

  bool found() const { return joint[2] != kNoJoint; }
};

/// What is known of a file's joints when limbs are matched.
struct NamedTree {
  const JointTree& tree;
  const std::vector<PlainName>& names;  ///< one per joint
  const motion::PerRole<int>& given;    ///< joints that the user gives; else kNoJoint
};

/// Finds the joints of two mirrored limbs as chains. A chain runs down the tree, has every required
/// role, and leaves no joint with length between two of its roles, but for those whose names say
/// that they are part of the upper one (twist bones, "upperarm02"). A joint without a known name is
/// taken where it is the only one below its neighbour, or lies between neighbours with names. The
/// lengths have to be possible for a human (thigh to shin, upper arm to forearm, foot to shin), and
/// the two limbs may not begin at one point. Of all chains, the two whose names fit best win; those
/// that name their joints alike and have the same lengths are preferred. Joints that the user gives
/// are taken as they are.
///
/// Returns a match that is not found for a limb without such a chain.
std::pair<LimbMatch, LimbMatch> match_limbs(const NamedTree& figure, const LimbRoles& left,
                                            const LimbRoles& right);

/// A joint and its role.
struct RoleJoint {
  motion::Role role;
  int joint;
};

/// Whether a joint between those of two roles needs no role: it is at the place of one of them, or
/// its name is that of a helper or of another part of the upper role's bone.
bool needs_no_role(const NamedTree& figure, int joint, const RoleJoint& upper,
                   const RoleJoint& lower);

/// Whether two neighbouring bones can have these lengths: `upper / lower` is at most a factor of 4
/// from the human ratio `expected`.
bool is_human_ratio(double upper, double lower, double expected);

/// Upper arm to forearm and thigh to shin: Drillis and Contini (1966).
inline constexpr double kUpperArmPerForearm = 0.186 / 0.146;
inline constexpr double kThighPerShin = 0.245 / 0.246;

}  // namespace flinch::database
