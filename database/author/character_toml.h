// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "motion/body.h"

namespace flinch::database {

/// Lengths of a character's body parts relative to a person of mean proportions and the same
/// height.
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

/// Makes a person of this height with these proportions, soles on the ground in the rest pose.
/// Throws Error at `where` for values outside the range of people: height 0.9 to 2.5 m, body mass
/// index 10 to 60 kg/m^2, proportions 0.6 to 1.6.
motion::Physique make_character(float height_m, float mass_kg, motion::Sex sex,
                                const Proportions& proportions, const std::string& where = "");

/// The name of waist_up_man() where a character's file may stand.
inline constexpr const char* kWaistUpMan = "waist_up_man";
/// The proportions of the man in appendix A of Rose (2006), from the waist up: a man of 1.75 m and
/// 75 kg whose torso, head, arms and hands have the appendix' lengths in units of 9.88 cm, so that
/// hips to crown are as long as a mean man's. He has a mean man's legs.
motion::Physique waist_up_man();

/// Reads a character from a TOML file (docs/authoring.md): height_m, mass_kg, sex and a table
/// [proportions], all optional; the defaults are those of default_character(), a mean man. Throws
/// Error "FILE:LINE: …".
motion::Physique read_character(const std::string& path);

/// Returns the character with that name, of a library or, if the file is none, of a TOML file.
/// Throws Error.
motion::Physique find_character(const std::string& path);

}  // namespace flinch::database
