// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/threat.h"
#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// A ball that is exported with a motion.
struct BallTrack {
  float radius = static_cast<float>(features::kVolleyballRadius_m);  ///< m
  /// Position of its centre for each pose of the motion, world, m; nothing where the ball is not
  /// visible. It is then scaled to 0 and stays where it was last visible, or will first be visible.
  std::vector<std::optional<Eigen::Vector3f>> positions;
};

/// Returns a motion as binary glTF 2.0 (.glb), which any viewer shows: the character as a skinned
/// figure (see motion/skin/figure_skin.h) that plays the motion, and optionally a ball.
///
/// Everything is in glTF's axes (Y up, Z forward, X to the left; see y_up.h) and in metres. The
/// scene has the roots "figure", which holds the skinned mesh; "pelvis", below which the other
/// joints are, named after their roles (see motion/role.h); and "ball". Without the animation, the
/// nodes are in the T-pose in which the mesh is bound. The mesh has one primitive per material.
///
/// The one animation, "motion", has one linear key per pose: the pelvis' translation; each joint's
/// rotation (quaternions in one hemisphere from key to key, so that no joint takes the longer arc);
/// the ball's translation; and, as steps, the ball's scale, 1 if visible or 0.
///
/// The same input gives the same bytes. Throws Error when the motion cannot be written (see
/// export_check.h), when the ball's radius is not above 0, when its positions are not finite, or
/// when there are not as many of them as poses.
std::vector<std::byte> make_glb(const motion::Physique& character, const motion::Motion& motion,
                                const std::optional<BallTrack>& ball = std::nullopt);

/// Text in the JSON of every file that write_glb makes and of no other program's.
inline constexpr std::string_view kGlbMark = "\"generator\":\"Flinch";

/// Writes the bytes to a file atomically. Throws Error.
void write_glb(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion, const std::optional<BallTrack>& ball = std::nullopt);

}  // namespace flinch::database
