// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "database/import/bvh.h"
#include "motion/role.h"

namespace flinch::database {

/// How a joint was found for a role.
enum class RoleSource : std::uint8_t {
  none,       ///< no such joint; the role follows its neighbours
  override_,  ///< given by the user
  name,       ///< by its known name
  topology,   ///< by its place in the hierarchy
};
std::string_view name_of(RoleSource source);

/// Which of a file's joints has which role.
struct RoleMap {
  motion::PerRole<int> joint{};          ///< index into Bvh::joints, -1: none
  motion::PerRole<RoleSource> source{};  ///< how it was found
};

/// Joint names that the user assigns to roles.
using RoleOverrides = std::map<motion::Role, std::string>;

/// Returns whether retargeting requires the role. Abdomen, neck, clavicles, hands and toes are
/// optional.
bool is_required(motion::Role role);

/// Maps a file's joints to roles: first by overrides, then by whole names as known rigs use them,
/// then by topology for the others.
///
/// The chest is the joint where the arms branch off; the abdomen the first joint with non-zero
/// length above the pelvis and below the chest; the neck the first with non-zero length between
/// chest and head. A neck without a head is the head. In the limbs, a joint without a known name is
/// taken from between its neighbours where only one candidate exists.
///
/// Throws Error when an override names a joint that the file does not have, when a required role is
/// missing (the message lists the unmapped joints and the TOML line that maps one), when a limb's
/// joints are not descendants of each other, or when the file holds no human figure.
RoleMap map_roles(const Bvh& bvh, const RoleOverrides& overrides = {});

/// Reads the table `[roles]` of a TOML file: `role = "joint name"`. Throws Error.
RoleOverrides read_role_overrides(const std::string& path);

}  // namespace flinch::database
