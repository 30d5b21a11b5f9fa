// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::motion {

/// A man of 1.75 m and 75 kg in mean proportions, his soles on the ground in the rest pose: for
/// tests, and where nobody gave a character. Heights of the joints, breadth of the hips and length
/// of the feet from Drillis and Contini (1966), as in Winter, "Biomechanics and Motor Control of
/// Human Movement", figure 4.1; lengths of the arms and heights on the trunk from de Leva (1996),
/// table 4, whose men are 1.741 m tall.
Physique default_character();

}  // namespace flinch::motion
