// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "evolve/pain/pain_region.h"
#include "sim/placed_impulse.h"

namespace flinch::evolve {

/// How much an impulse hurts at each place.
struct PainMap {
  PerPainRegion<double> multiplier;
};

/// Figure 4.5 of Rose (2006): hands 1, chest and upper arms 2, forearms 3, stomach 4, head 5, face
/// 10, nose 14, eyes 15. Neck and pelvis, which its figure lacks, hurt as head and stomach do, legs
/// and feet as arms and hands. Backs of hands hurt as palms do, as there.
const PainMap& thesis_pain();

/// Reads a pain map from a TOML file with a table [multipliers] of regions and numbers from 0
/// to 1000; regions that it leaves out keep those of thesis_pain(). Throws Error "FILE:LINE: …",
/// for a region that does not exist with a list of those that do.
PainMap read_pain(const std::string& path);

/// Equation 4.2 with impulses in place of forces in each step, so that it does not depend on the
/// step: the sum of P(p_i) |J_i|, N·s.
double pain_of(const PainMap& map, const motion::BodyModel& bodies,
               std::span<const sim::PlacedImpulse> impulses);

}  // namespace flinch::evolve
