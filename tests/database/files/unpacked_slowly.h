// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "motion/skeleton.h"

namespace flinch::tests {

/// The slow twin of database::unpack_poses(): bit by bit, number by number, in doubles, from the
/// description in packed_poses.h. For well-formed bytes only.
std::vector<motion::Pose> unpacked_slowly(const std::vector<std::uint8_t>& bytes);

}  // namespace flinch::tests
