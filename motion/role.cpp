// SPDX-License-Identifier: MIT
#include "motion/role.h"

namespace flinch::motion {
namespace {

struct RoleInfo {
  std::string_view name;
  Role parent;  // the pelvis names itself
  Role mirrored;
};

constexpr std::array<RoleInfo, kRoleCount> kRoleInfo{{
    {"pelvis", Role::pelvis, Role::pelvis},
    {"abdomen", Role::pelvis, Role::abdomen},
    {"chest", Role::abdomen, Role::chest},
    {"neck", Role::chest, Role::neck},
    {"head", Role::neck, Role::head},
    {"left_clavicle", Role::chest, Role::right_clavicle},
    {"left_upper_arm", Role::left_clavicle, Role::right_upper_arm},
    {"left_forearm", Role::left_upper_arm, Role::right_forearm},
    {"left_hand", Role::left_forearm, Role::right_hand},
    {"right_clavicle", Role::chest, Role::left_clavicle},
    {"right_upper_arm", Role::right_clavicle, Role::left_upper_arm},
    {"right_forearm", Role::right_upper_arm, Role::left_forearm},
    {"right_hand", Role::right_forearm, Role::left_hand},
    {"left_thigh", Role::pelvis, Role::right_thigh},
    {"left_shin", Role::left_thigh, Role::right_shin},
    {"left_foot", Role::left_shin, Role::right_foot},
    {"left_toes", Role::left_foot, Role::right_toes},
    {"right_thigh", Role::pelvis, Role::left_thigh},
    {"right_shin", Role::right_thigh, Role::left_shin},
    {"right_foot", Role::right_shin, Role::left_foot},
    {"right_toes", Role::right_foot, Role::left_toes},
}};

constexpr const RoleInfo& info_of(Role role) {
  return kRoleInfo[static_cast<std::size_t>(role)];
}

}  // namespace

std::optional<Role> parent_of(Role role) {
  if (role == Role::pelvis) return std::nullopt;
  return info_of(role).parent;
}

Role mirrored(Role role) {
  return info_of(role).mirrored;
}

std::string_view name_of(Role role) {
  return info_of(role).name;
}

std::optional<Role> role_named(std::string_view name) {
  for (Role role : kRoles) {
    if (name_of(role) == name) return role;
  }
  return std::nullopt;
}

}  // namespace flinch::motion
