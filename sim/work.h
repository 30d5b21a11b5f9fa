// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::sim {

/// Filters a path of positions (m, at `rate_hz`) with a second-order Butterworth low-pass at 12 Hz,
/// forwards and backwards: no phase shift, -6 dB at 12 Hz. Extends the path beyond its ends by its
/// reflection about the end point. Returns the path unchanged if the rate is too low to carry 12
/// Hz.
std::vector<Eigen::Vector3d> low_pass_filtered(const std::vector<Eigen::Vector3d>& path,
                                               double rate_hz);

/// Mechanical work of each body over a motion, J (Zordan et al. 2007, section 4):
///
///     W_i = sum over poses |m_i a_i . ds_i|
///
/// with a_i and ds_i by central differences of the body's centre of mass after low_pass_filtered. A
/// signed sum would telescope to the change of kinetic energy, which is zero from rest to rest.
/// Motions of fewer than four poses do no work.
motion::PerBody<double> mechanical_work(const motion::Physique& character,
                                        const motion::Motion& motion);

}  // namespace flinch::sim
