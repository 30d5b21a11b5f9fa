// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "motion/skeleton.h"

namespace flinch::database {

/// Poses on the grid of pose_grid.h as files hold them, least significant byte and bit first:
///
///     number of poses                            4 bytes
///     for x, y and z of the root: a track        5 bytes each
///     for each role: the derived component       1 byte: its code, or kDerivedPerPose
///                    three tracks, the others    5 bytes each
///     the bits, in the same order
///     zeros                                      up to a whole byte, and kPaddingBytes
///
/// A track is a sequence of grid numbers, one per pose: the first one (4 bytes), then a byte with
/// the width w of what follows (low five bits) and its order n (the bits above). Its bits are w for
/// each further pose, a residual with its sign in the lowest bit. It is added to what the numbers
/// before predict: the first number (order 0), the last one (1), or that continued along a straight
/// line (2). Before the first track of a role whose derived component differs from pose to pose are
/// 3 bits per pose, its codes.
inline constexpr std::size_t kRootTracks = 3;
inline constexpr std::size_t kTracksPerRotation = 3;
inline constexpr std::size_t kTrackHeaderBytes = 5;
inline constexpr unsigned kWidthBits = 5;
inline constexpr unsigned kMaxOrder = 2;
inline constexpr unsigned kDerivedPerPose = 8;
inline constexpr unsigned kDerivedBits = 3;
inline constexpr std::size_t kPaddingBytes = 8;  ///< so that any value can be read as 8 bytes
inline constexpr std::size_t kPackedHeaderBytes =
    4 + kTrackHeaderBytes * kRootTracks +
    static_cast<std::size_t>(motion::kRoleCount) * (1 + kTrackHeaderBytes * kTracksPerRotation);

/// The number of poses that `bytes` say they hold; none if they are too few for that.
std::optional<std::size_t> packed_pose_count(std::span<const std::uint8_t> bytes);

/// Unpacks all poses. Returns false, with any content in `poses`, if the bytes are not as above, a
/// root is farther away than kMaxDistance_m, or three components of a rotation are longer than 1.
bool unpack_poses(std::span<const std::uint8_t> bytes, std::vector<motion::Pose>& poses);

}  // namespace flinch::database
