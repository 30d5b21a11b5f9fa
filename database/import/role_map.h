// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "database/import/bvh.h"
#include "motion/role.h"

namespace flinch::database {

/// How a joint came to its role.
enum class RoleSource : std::uint8_t {
  none,       ///< there is no such joint; the role follows its neighbours
  override_,  ///< the user said so
  name,       ///< its name is known
  topology,   ///< from where it hangs
};
std::string_view name_of(RoleSource source);

/// Which of a file's joints plays which role.
struct RoleMap {
  motion::PerRole<int> joint{};          ///< index into Bvh::joints, -1: none
  motion::PerRole<RoleSource> source{};  ///< how it was found
};

/// Joint names that the user gives to roles.
using RoleOverrides = std::map<motion::Role, std::string>;

/// A role without which a skeleton cannot be retargeted. The abdomen, neck, clavicles, hands and
/// toes may be missing.
bool is_required(motion::Role role);

/// Maps a file's joints to roles: overrides first, then whole names as known rigs use them, then
/// topology for what names leave open.
///
/// The chest is the joint where the arms part; the abdomen the first joint with a length above the
/// pelvis and below the chest; the neck the first with a length between chest and head; a neck
/// without a head is the head. In the limbs a joint that no name gives is taken from its
/// neighbours where only one can be meant.
///
/// Throws Error when an override names no role's joint, when a needed role is missing (it lists
/// the joints left over and the TOML line that maps one), when a limb's joints do not hang from
/// each other, or when the file holds no human figure.
RoleMap map_roles(const Bvh& bvh, const RoleOverrides& overrides = {});

/// Reads the table `[roles]` of a TOML file: `role = "joint name"`. Throws Error.
RoleOverrides read_role_overrides(const std::string& path);

}  // namespace flinch::database
