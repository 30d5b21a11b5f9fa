// SPDX-License-Identifier: MIT
#pragma once

#include "database/export/solid_mesh.h"
#include "motion/body.h"

namespace flinch::database {

/// A surface whose every vertex moves with one joint.
struct SkinnedMesh {
  Mesh mesh;
  std::vector<motion::Role> joints;  ///< one a vertex
};

/// A figure to look at, in the rest pose, in the world (Z up, the character faces +X).
struct FigureMesh {
  SkinnedMesh body;     ///< the outlines of trunk, head, arms and legs
  SkinnedMesh accents;  ///< hands, feet, neck, what fills the joints, and the visor of the face
};

/// The figure that a character's outlines make (see motion::make_body_model): capsules as they are,
/// boxes with rounded edges. Balls at the joints of the limbs and a disc above and below the waist
/// keep a bent figure together, and a visor shows where the head looks. Throws Error when a size is
/// not finite.
FigureMesh figure_mesh(const motion::Physique& character);

}  // namespace flinch::database
