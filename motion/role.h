// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "motion/enum_array.h"

namespace flinch::motion {

/// The joints of a character, parents first. A role names the joint at the near end of its segment:
/// `left_forearm` is the left elbow. Import maps other skeletons to these roles.
enum class Role : std::uint8_t {
  pelvis,
  abdomen,
  chest,
  neck,
  head,
  left_clavicle,
  left_upper_arm,
  left_forearm,
  left_hand,
  right_clavicle,
  right_upper_arm,
  right_forearm,
  right_hand,
  left_thigh,
  left_shin,
  left_foot,
  left_toes,
  right_thigh,
  right_shin,
  right_foot,
  right_toes,
};

/// The number of roles.
inline constexpr int kRoleCount = 21;

/// All roles, parents first, for range-based loops.
inline constexpr auto kRoles = all_enumerators<Role, kRoleCount>();

/// One value per role.
template <class T>
using PerRole = EnumArray<Role, T, kRoleCount>;

/// The parent of each role; that of the pelvis is the pelvis.
inline constexpr PerRole<Role> kParents{
    Role::pelvis,        Role::pelvis, Role::abdomen,        Role::chest,
    Role::neck,          Role::chest,  Role::left_clavicle,  Role::left_upper_arm,
    Role::left_forearm,  Role::chest,  Role::right_clavicle, Role::right_upper_arm,
    Role::right_forearm, Role::pelvis, Role::left_thigh,     Role::left_shin,
    Role::left_foot,     Role::pelvis, Role::right_thigh,    Role::right_shin,
    Role::right_foot};

/// The parent of `role`; none for the pelvis, which is the root.
constexpr std::optional<Role> parent_of(Role role) {
  if (role == Role::pelvis) return std::nullopt;
  return kParents[role];
}

/// The same role on the other side of the body; roles in the middle return themselves.
Role mirrored(Role role);

/// The role's name in files, options and messages, such as "left_upper_arm".
std::string_view name_of(Role role);

/// The role with this name, if there is one.
std::optional<Role> role_named(std::string_view name);

}  // namespace flinch::motion
