// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "motion/body.h"
#include "motion/skin/covering.h"

namespace flinch::motion {

/// The most joints that move one vertex.
inline constexpr std::size_t kMaxSkinJoints = 4;

/// A figure to be displayed: closed surfaces of triangles in the rest pose, world (Z up, the
/// character faces +X), whose vertices move with the joints (linear blend skinning). With the
/// positions p_i and orientations R_i of the joints of a vertex v, and r_i their positions at rest,
/// where all orientations are the identity:
///   v' = sum_i w_i (p_i + R_i (v - r_i))
struct FigureSkin {
  std::vector<Eigen::Vector3f> positions;                  ///< m
  std::vector<Eigen::Vector3f> normals;                    ///< unit, outward; one per position
  std::vector<std::array<Role, kMaxSkinJoints>> joints;    ///< one set per position
  std::vector<std::array<float, kMaxSkinJoints>> weights;  ///< 0 or more, largest first; sum 1
  /// Counter-clockwise from outside, by what they show.
  PerCovering<std::vector<std::array<std::uint32_t, 3>>> triangles;
};

/// Makes a figure that looks like a person in shirt, trousers and shoes, shaped after the
/// character's bones and outlines (see make_body_model): one surface for the body, and small ones
/// for eyes, eyebrows, ears and lips; fewer than 6000 vertices. For a character of 1.75 m, no
/// vertex is more than 5 cm outside the outlines, and no point of the outlines more than 7 cm
/// outside the surface, so what is seen is what is hit. The halves of a symmetric character are
/// mirror images.
///
/// Opens no file and throws nothing but std::bad_alloc.
FigureSkin make_figure_skin(const Physique& character);

}  // namespace flinch::motion
