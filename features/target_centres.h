// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

#include "motion/clip.h"

namespace flinch::features {

/// One point per target, m.
using TargetCentres = std::array<Eigen::Vector3f, motion::kTargetCount>;

}  // namespace flinch::features
