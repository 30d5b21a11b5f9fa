// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// A ball that is shown with a motion.
struct BallTrack {
  float radius = 0.105F;  ///< m
  /// Of its centre, world, m: one a pose of the motion. Nothing while there is no ball to see: then
  /// it has no size, and waits where it was last seen, or will be seen first.
  std::vector<std::optional<Eigen::Vector3f>> positions;
};

/// A motion as binary glTF 2.0 (.glb), which any viewer shows: the character's outlines as a
/// skinned figure (see figure_mesh.h) that plays the motion, and the ball beside it.
///
/// The scene has two roots. "figure" holds the skinned mesh; "flinch" turns our axes (Z up, X
/// forward, Y left) into glTF's (Y up, Z forward, X left): (x, y, z) becomes (y, z, x), a turn by
/// 120 degrees. All below it is in ours, in metres: the joints, named after their roles (see
/// motion/role.h), and "ball". The nodes rest in the T-pose in which the mesh is bound.
///
/// The one animation, "motion", has a linear key a pose: the pelvis' translation, each joint's
/// rotation (quaternions on the same side from key to key, so that nothing turns the long way), the
/// ball's translation, and the ball's scale in steps, 1 or 0: whether it is there.
///
/// The same input gives the same bytes. Throws Error when the motion cannot be written (see
/// export_check.h), or when the ball's radius is not above 0, its positions are not finite or are
/// not as many as the poses.
std::vector<std::byte> make_glb(const motion::Physique& character, const motion::Motion& motion,
                                const std::optional<BallTrack>& ball = std::nullopt);

/// Writes it to a file, whole or not at all. Throws Error.
void write_glb(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion, const std::optional<BallTrack>& ball = std::nullopt);

}  // namespace flinch::database
