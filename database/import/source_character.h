// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/import/source_motion.h"
#include "motion/body.h"

namespace flinch::database {

/// What a manifest may say of its character; what is not said is estimated.
struct CharacterOptions {
  std::optional<float> mass_kg;
  std::optional<float> height_m;  ///< to the crown; all lengths are scaled to it
  motion::Sex sex = motion::Sex::male;
};

/// The body mass index of a character whose mass is not given, kg/m^2: an estimate, within the
/// range that the World Health Organization calls normal (18.5 to 25).
inline constexpr float kDefaultBodyMassIndex = 23;

/// The library's character from a source's reference pose: bone lengths in metres, left and right
/// averaged so that they are exact mirror images, the limbs and the spine straight, the soles on
/// the ground. What the source does not have (neck, hands, toes, crown) is in the proportions of
/// motion::default_character. So is the place of abdomen and chest on the spine where the source's
/// spine joints are not at their anatomical places: some rigs bend at the shoulders only.
motion::Physique character_of(const Source& source, const CharacterOptions& options = {});

}  // namespace flinch::database
