// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "motion/role.h"

namespace flinch::database {

/// Side of the body in a joint's name.
enum class NameSide : std::uint8_t { none, left, right };

/// A joint's name without the parts that differ between tools.
struct PlainName {
  /// Lower case, without namespace, rig prefix, side and separators: "mixamorig:LeftUpLeg" and
  /// "CC_Base_L_UpLeg" are both "upleg".
  std::string stem;
  NameSide side = NameSide::none;
};

/// Parses a name: removes namespaces ("mixamorig:", "a|b"), the prefixes of known rigs ("CC_Base_",
/// "Bip01 ", "DEF-", "J_Bip_", …), the side as first or last word ("Left", "l", "_R", ".L") and the
/// separators between words.
PlainName plain_name(std::string_view name);

/// Returns the side of a role; none for roles in the middle.
NameSide side_of(motion::Role role);

/// Returns the stems that known rigs use for the role, the most common first. A stem matches only
/// as a whole and with the role's side: twist bones, dummies and helpers share parts of the names
/// of the joints that they belong to.
std::span<const std::string_view> stems_of(motion::Role role);

}  // namespace flinch::database
