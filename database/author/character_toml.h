// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "motion/body.h"

namespace flinch::database {

/// Lengths of a character's parts relative to a person of mean proportions and the same height.
struct Proportions {
  float legs = 1;
  float arms = 1;
  float trunk = 1;
  float neck = 1;
  float head = 1;
  float hands = 1;
  float feet = 1;
  float shoulders = 1;  ///< breadth
  float hips = 1;       ///< breadth
};

/// A person of this height with these proportions, soles on the ground in the rest pose. Throws
/// Error, with `where`, for what no person is: a height not in 0.9 to 2.5 m, a body mass index not
/// in 10 to 60 kg/m^2, or a proportion not in 0.6 to 1.6.
motion::Physique make_character(float height_m, float mass_kg, motion::Sex sex,
                                const Proportions& proportions, const std::string& where = "");

/// Reads a character from a TOML file (docs/authoring.md): height_m, mass_kg, sex and a table
/// [proportions], all optional; the mean man of default_character() without. Throws Error
/// "FILE:LINE: …".
motion::Physique read_character(const std::string& path);

}  // namespace flinch::database
