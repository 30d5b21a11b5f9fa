// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "evolve/genetic/chromosome.h"
#include "motion/figure.h"

namespace flinch::evolve {

/// A degree of freedom of evolved poses: an angle of a row of motion::human_joint_limits(), with
/// that row's meaning.
struct PoseGene {
  std::string_view joint;
  int axis = 0;     ///< 0 x, 1 y, 2 z
  GeneRange range;  ///< radians
};

/// The 20 genes of a pose of the upper body: trunk 3, neck 3, and of each arm shoulder 3, elbow 2,
/// wrist 2. Trunk and neck have the limits of appendix A of Rose (2006), whose trunk hardly bends;
/// arms have those of people. They map onto their limits; with equation 4.5 most genes would lie
/// beyond them.
std::span<const PoseGene> pose_genes();

/// Returns the standing pose with the angles that the genes stand for, balanced over the feet of
/// `start`, which stands there. Half of the trunk's angles go to the abdomen and half of the neck's
/// to the neck.
motion::Pose pose_of(const motion::Figure& figure, const motion::Pose& start,
                     const Chromosome& chromosome);

}  // namespace flinch::evolve
