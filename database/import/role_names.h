// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "motion/role.h"

namespace flinch::database {

/// Which side of the body a joint's name speaks of.
enum class NameSide : std::uint8_t { none, left, right };

/// A joint's name without what differs between tools.
struct PlainName {
  /// Lower case, without namespace, rig prefix, side and separators: "mixamorig:LeftUpLeg" and
  /// "CC_Base_L_UpLeg" are both "upleg".
  std::string stem;
  NameSide side = NameSide::none;
};

/// Takes a name apart: namespaces ("mixamorig:", "a|b"), the prefixes of known rigs ("CC_Base_",
/// "Bip01 ", "DEF-", "J_Bip_", …), the side as first or last word ("Left", "l", "_R", ".L") and the
/// separators between words.
PlainName plain_name(std::string_view name);

/// The side of a role; none for those in the middle.
NameSide side_of(motion::Role role);

/// The stems that name the role in the rigs that are known, the likeliest first. A stem counts only
/// as a whole, and only with the role's side: parts of names are what twist bones, dummies and
/// helpers share with the joints that they help.
std::span<const std::string_view> stems_of(motion::Role role);

}  // namespace flinch::database
