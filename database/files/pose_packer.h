// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "database/library/library.h"

namespace flinch::database {

/// Moves all poses to the nearest points of the grid that files keep (pose_grid.h), so that what is
/// in memory is, bit for bit, what a file gives back. Poses on the grid stay as they are, and
/// mirrored clips stay mirror images. The poses must be sound. Rotations keep their signs.
void snap(motion::Motion& motion);
void snap(ClipLibrary& library);

/// Poses as packed_poses.h describes; none unless there are some and every one is on the grid.
std::optional<std::vector<std::uint8_t>> pack_poses(const std::vector<motion::Pose>& poses);

}  // namespace flinch::database
