// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "motion/role.h"

namespace flinch::database {

/// How well a name fits a role.
enum class NameFit : std::uint8_t {
  none,
  /// The rig names another point of the limb: `foot` for the ball of the foot in rigs that have an
  /// ankle, `knee` for the thigh in rigs whose bones are named after their far end.
  possible,
  likely,  ///< one of two roles, depending on the rig: "shoulder", "leg"
  exact,
};

/// What a name without side, prefix, suffix and number can mean.
struct KnownStem {
  std::string_view stem;
  motion::Role left_role;  ///< on the left side; the name's side decides which side it is
  NameFit fit;
};

/// The vocabulary of limbs, of the rigs that docs/importing.md lists.
std::span<const KnownStem> limb_stems();

/// Stems of a role in the middle of the body, the most common first. Nothing for abdomen and chest:
/// their number and names vary, so they are found by topology.
std::span<const std::string_view> middle_stems(motion::Role role);

/// Prefixes that known rigs put before every name, as lower-case words with spaces between.
std::span<const std::string_view> rig_prefixes();

/// Words that make a name that of a joint without a role: of a twist bone, a helper, a finger, the
/// tip of a limb, an IK target.
std::span<const std::string_view> helper_words();

}  // namespace flinch::database
