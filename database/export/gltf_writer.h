// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "database/export/ball_track.h"
#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::database {

/// What is known about a motion. Times are in seconds from its first pose. What is absent or empty
/// is not known and not written.
struct MotionFacts {
  std::string clip{};  ///< name of the clip that it is, or that it plays
  std::optional<motion::Annotation> annotation{};  ///< of the clip, if the motion is the whole clip
  std::optional<float> impact_s{};                 ///< when the threat was predicted to hit
  std::optional<float> contact_s{};                ///< when the ball touched the figure first
  std::optional<motion::Body> hit_body{};          ///< the body with the largest impulse
  std::optional<float> impulse_ns{};               ///< on all bodies, N s
};

/// One of several motions in a file.
struct NamedMotion {
  std::string name;  ///< of the animation
  motion::Motion motion;
  MotionFacts facts;
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
/// the ball's translation, and of a rod its rotation; and, as steps, its scale, 1 if visible or 0.
/// Its `extras` hold the facts: `clip`; of the annotation `target`, `direction_degrees`, `degree`,
/// `onset_s`, `peak_s` and `end_s`; `impact_s`, `contact_s`, `hit_body` and `impulse_ns`.
///
/// The same input gives the same bytes. Throws Error when the motion cannot be written (see
/// export_check.h), when the ball's radius is not above 0, when its positions are not finite, or
/// when there are not as many of them, or of a rod's axes, as poses.
std::vector<std::byte> make_glb(const motion::Physique& character, const motion::Motion& motion,
                                const std::optional<BallTrack>& ball = std::nullopt,
                                const MotionFacts& facts = {});

/// Returns several motions of one character as one file with an animation for each, in their order.
/// Everything else is as above, without a ball. Throws Error also when there is no motion.
std::vector<std::byte> make_glb(const motion::Physique& character,
                                std::span<const NamedMotion> motions);

/// Returns motions that take place together, one per figure of the same character: equally many
/// poses at the same rate, else throws Error. The nodes of the second figure end in "_2", and so
/// on; all move in the one animation, "motion".
std::vector<std::byte> make_group_glb(const motion::Physique& character,
                                      std::span<const motion::Motion> motions);

/// Text in the JSON of every file that write_glb makes and of no other program's.
inline constexpr std::string_view kGlbMark = "\"generator\":\"Flinch";

/// Writes the bytes to a file atomically. Throws Error.
void write_glb(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion, const std::optional<BallTrack>& ball = std::nullopt,
               const MotionFacts& facts = {});
/// The same for several motions.
void write_glb(const std::string& path, const motion::Physique& character,
               std::span<const NamedMotion> motions);
/// The same for a group.
void write_group_glb(const std::string& path, const motion::Physique& character,
                     std::span<const motion::Motion> motions);

}  // namespace flinch::database
