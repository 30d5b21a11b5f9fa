// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "database/import/role_vocabulary.h"
#include "motion/role.h"

namespace flinch::database {

/// Side of the body in a joint's name.
enum class NameSide : std::uint8_t { none, left, right };

/// A joint's name without the parts that differ between tools.
struct PlainName {
  /// Lower case, without namespace, rig prefix, side, separators and the number at its end:
  /// "mixamorig:LeftUpLeg" and "CC_Base_L_UpLeg" are both "upleg".
  std::string stem;
  std::string number;  ///< the digits at the end of the name: "01" of "upperarm01.L"
  NameSide side = NameSide::none;
  /// Whether the name is that of a joint which has no role of its own: of a twist bone, a helper, a
  /// finger, the tip of a limb, an IK target.
  bool is_helper = false;
};

/// Parses a name: removes namespaces ("mixamorig:", "a|b"), the prefixes of known rigs ("CC_Base_",
/// "Bip01 ", "DEF-", "J_Bip_", …), the side ("Left", "l", "_R", ".L", "左") and the separators
/// between words.
PlainName plain_name(std::string_view name);

/// Parses the names of one rig's joints, the root's first: also removes the words that at least two
/// thirds of them, without helpers, share at one end ("Robot_", "_JNT"), and letters that all
/// share. Nothing is removed where fewer names would be known afterwards.
std::vector<PlainName> plain_names(std::vector<std::string> names);

/// Returns the side of a role; none for roles in the middle.
NameSide side_of(motion::Role role);

/// Returns how well the name fits the role, whatever the lengths say. A stem fits only as a whole
/// and with the role's side: twist bones, dummies and helpers share parts of the names of the
/// joints that they belong to.
NameFit fit_of(const PlainName& name, motion::Role role);

/// Returns whether a joint of the spine, neck or head has this name, alone or as the first of
/// several: "neck" and "neck01" are a neck, "neck02" is not.
bool is_named(const PlainName& name, std::string_view middle_stem);

}  // namespace flinch::database
