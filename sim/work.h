// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::sim {

/// Mechanical work of each body over a motion, J (Zordan et al. 2007, section 4):
///
///     W_i = sum over poses |m_i a_i . ds_i|
///
/// with a_i by central differences of the body's centre of mass after a zero-phase low-pass at
/// 12 Hz (second-order Butterworth, forwards and backwards). Signed, the sum would telescope to the
/// change of kinetic energy, which is nothing from rest to rest. Motions of fewer than four poses
/// do no work.
motion::PerBody<double> mechanical_work(const motion::Character& character,
                                        const motion::Motion& motion);

}  // namespace flinch::sim
