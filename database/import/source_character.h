// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/import/source_motion.h"
#include "motion/body.h"

namespace flinch::database {

/// What a manifest may state about its character; everything else is estimated.
struct CharacterOptions {
  std::optional<float> mass_kg;
  std::optional<float> height_m;  ///< to the crown; all lengths are scaled to match
  motion::Sex sex = motion::Sex::male;
};

/// Body mass index assumed for a character without a given mass, kg/m^2: an estimate, within the
/// range that the World Health Organization calls normal (18.5 to 25).
inline constexpr float kDefaultBodyMassIndex = 23;

/// Makes the library's character from a source's reference pose: bone lengths in metres, averaged
/// over left and right so that the sides are exact mirror images; straight limbs; the spine in the
/// plane of symmetry, with the source's curvature; soles on the ground. Parts that the source does
/// not have (neck, hands, toes, crown) have the proportions of motion::default_character. The same
/// applies to the heights of abdomen and chest and to the clavicles where the source's joints are
/// not at their anatomical places: some rigs bend only at the shoulders.
motion::Physique character_of(const Source& source, const CharacterOptions& options = {});

}  // namespace flinch::database
