// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::motion {

/// Returns a man of 1.75 m and 75 kg with mean proportions, whose soles are on the ground in the
/// rest pose. Used in tests and wherever no character is given. Joint heights, hip breadth and foot
/// length are from Drillis and Contini (1966), as in Winter, "Biomechanics and Motor Control of
/// Human Movement", figure 4.1; arm lengths and heights on the trunk are from de Leva (1996), table
/// 4, whose men are 1.741 m tall.
Physique default_character();

}  // namespace flinch::motion
