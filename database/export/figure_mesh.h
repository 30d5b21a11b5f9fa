// SPDX-License-Identifier: MIT
#pragma once

#include "database/export/solid_mesh.h"
#include "motion/body.h"

namespace flinch::database {

/// A surface in which every vertex moves with one joint.
struct SkinnedMesh {
  Mesh mesh;
  std::vector<motion::Role> joints;  ///< one per vertex
};

/// A displayable figure in the rest pose, world (Z up, the character faces +X).
struct FigureMesh {
  SkinnedMesh body;     ///< the outlines of trunk, head, arms and legs
  SkinnedMesh accents;  ///< hands, feet, neck, joint fillers, and the visor in front of the face
};

/// Makes a figure from a character's outlines (see motion::make_body_model): capsules unchanged,
/// boxes with rounded edges. Balls at the joints of the limbs and a disc above and below the waist
/// fill the gaps of a bent figure, and a visor shows where the head looks. Throws Error when a size
/// is not finite.
FigureMesh figure_mesh(const motion::Physique& character);

}  // namespace flinch::database
