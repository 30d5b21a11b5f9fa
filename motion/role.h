// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace flinch::motion {

/// The joints that code asks for, parents first. A role names the joint at the near end of its
/// segment: `left_forearm` is the left elbow. Foreign skeletons are mapped to roles at import.
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

inline constexpr int kRoleCount = 21;

/// All roles, parents first, for range loops.
inline constexpr std::array<Role, kRoleCount> kRoles = [] {
  std::array<Role, kRoleCount> roles{};
  for (int i = 0; i < kRoleCount; ++i) roles[static_cast<std::size_t>(i)] = static_cast<Role>(i);
  return roles;
}();

/// One value a role.
template <class T>
class PerRole {
 public:
  constexpr T& operator[](Role role) { return values_[static_cast<std::size_t>(role)]; }
  constexpr const T& operator[](Role role) const { return values_[static_cast<std::size_t>(role)]; }
  constexpr auto begin() { return values_.begin(); }
  constexpr auto end() { return values_.end(); }
  constexpr auto begin() const { return values_.begin(); }
  constexpr auto end() const { return values_.end(); }

 private:
  std::array<T, kRoleCount> values_{};
};

/// What each role hangs from, in their order; the pelvis names itself.
inline constexpr std::array<Role, kRoleCount> kParents{
    Role::pelvis,        Role::pelvis, Role::abdomen,        Role::chest,
    Role::neck,          Role::chest,  Role::left_clavicle,  Role::left_upper_arm,
    Role::left_forearm,  Role::chest,  Role::right_clavicle, Role::right_upper_arm,
    Role::right_forearm, Role::pelvis, Role::left_thigh,     Role::left_shin,
    Role::left_foot,     Role::pelvis, Role::right_thigh,    Role::right_shin,
    Role::right_foot};

/// The role that `role` hangs from; nothing for the pelvis, which is the root.
constexpr std::optional<Role> parent_of(Role role) {
  if (role == Role::pelvis) return std::nullopt;
  return kParents[static_cast<std::size_t>(role)];
}

/// The same role on the other side; roles in the middle are their own.
Role mirrored(Role role);

/// The role's name as files, options and messages write it, such as "left_upper_arm".
std::string_view name_of(Role role);

/// The role with that name, if there is one.
std::optional<Role> role_named(std::string_view name);

}  // namespace flinch::motion
