// SPDX-License-Identifier: MIT
#include "motion/role.h"

namespace flinch::motion {
namespace {

struct Entry {
  std::string_view name;
  Role mirrored;
};

constexpr std::array<Entry, kRoleCount> kEntries{{
    {"pelvis", Role::pelvis},
    {"abdomen", Role::abdomen},
    {"chest", Role::chest},
    {"neck", Role::neck},
    {"head", Role::head},
    {"left_clavicle", Role::right_clavicle},
    {"left_upper_arm", Role::right_upper_arm},
    {"left_forearm", Role::right_forearm},
    {"left_hand", Role::right_hand},
    {"right_clavicle", Role::left_clavicle},
    {"right_upper_arm", Role::left_upper_arm},
    {"right_forearm", Role::left_forearm},
    {"right_hand", Role::left_hand},
    {"left_thigh", Role::right_thigh},
    {"left_shin", Role::right_shin},
    {"left_foot", Role::right_foot},
    {"left_toes", Role::right_toes},
    {"right_thigh", Role::left_thigh},
    {"right_shin", Role::left_shin},
    {"right_foot", Role::left_foot},
    {"right_toes", Role::left_toes},
}};

constexpr const Entry& entry(Role role) {
  return kEntries[static_cast<std::size_t>(role)];
}

}  // namespace

Role mirrored(Role role) {
  return entry(role).mirrored;
}

std::string_view name_of(Role role) {
  return entry(role).name;
}

std::optional<Role> role_named(std::string_view name) {
  for (Role role : kRoles) {
    if (name_of(role) == name) return role;
  }
  return std::nullopt;
}

}  // namespace flinch::motion
