// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "database/import/bvh.h"
#include "motion/error.h"
#include "motion/role.h"

namespace flinch::database {

/// How a joint was found for a role.
enum class RoleSource : std::uint8_t {
  none,       ///< no such joint; the role follows its neighbours
  override_,  ///< given by the user
  name,       ///< by its known name
  topology,   ///< by its place in the hierarchy, and its lengths
};
std::string_view name_of(RoleSource source);

/// Which of a file's joints has which role.
struct RoleMap {
  motion::PerRole<int> joint{};          ///< index into Bvh::joints, -1: none
  motion::PerRole<RoleSource> source{};  ///< how it was found
};

/// Joint names that the user assigns to roles.
using RoleOverrides = std::map<motion::Role, std::string>;

/// The roles that retargeting requires. Abdomen, neck, clavicles, hands and toes are optional.
inline constexpr std::array kRequiredRoles{
    motion::Role::pelvis,         motion::Role::chest,        motion::Role::head,
    motion::Role::left_upper_arm, motion::Role::left_forearm, motion::Role::left_thigh,
    motion::Role::left_shin,      motion::Role::left_foot,    motion::Role::right_upper_arm,
    motion::Role::right_forearm,  motion::Role::right_thigh,  motion::Role::right_shin,
    motion::Role::right_foot,
};

/// Returns whether the role is one of kRequiredRoles.
bool is_required(motion::Role role);

/// Thrown where a file's joints cannot be mapped. what() is one line; `suggestion` is a table for a
/// TOML file that a user can correct and give as the roles: a comment, `[roles]`, and lines of
/// `role = "joint name"`. Empty where the skeleton's shape suggests nothing.
class RoleError : public Error {
 public:
  RoleError(const std::string& where, const std::string& what, std::string suggestion_text)
      : Error(where, what), suggestion(std::move(suggestion_text)) {}
  std::string suggestion;
};

/// Maps a file's joints to roles: overrides first, then names as known rigs use them, then
/// topology.
///
/// Limbs are matched whole, both of a pair together (limb_match.h). The chest is the joint where
/// the arms branch off; the abdomen the first joint with non-zero length above the pelvis and below
/// the chest; the neck the first with non-zero length between chest and head. A neck without a head
/// is the head.
///
/// Throws Error when an override names a joint that the file does not have, and RoleError when a
/// required role is missing, when a limb's joints are not descendants of each other, when a joint
/// with length lies between two roles of a limb and has no role, when lengths or mirrored limbs
/// contradict the names, or when the file holds no human figure.
RoleMap map_roles(const Bvh& bvh, const RoleOverrides& overrides = {});

/// Reads the table `[roles]` of a TOML file: `role = "joint name"`. Throws Error.
RoleOverrides read_role_overrides(const std::string& path);

}  // namespace flinch::database
