// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "evolve/genetic/chromosome.h"
#include "motion/figure.h"

namespace flinch::evolve {

/// A degree of freedom of evolved poses: an angle of a row of motion::human_joint_limits(), with
/// that row's meaning, or how the pelvis moves.
struct PoseGene {
  std::string_view joint;
  int axis = 0;     ///< 0 x, 1 y, 2 z
  GeneRange range;  ///< radians; of kPelvisShift lengths of the leg
};
/// How far the pelvis moves, and how it turns, from the start, in its frame there: rows that are
/// not among motion::human_joint_limits().
inline constexpr std::string_view kPelvisShift = "pelvis_shift";
inline constexpr std::string_view kPelvisTurn = "pelvis_turn";

/// The 20 genes of a pose of the upper body: trunk 3, neck 3, and of each arm shoulder 3, elbow 2,
/// wrist 2. Trunk and neck have the limits of appendix A of Rose (2006), whose trunk hardly bends;
/// arms have those of people.
std::span<const PoseGene> pose_genes();
/// The 26 genes of a pose of the whole body, which can lean, bend and crouch too: the pelvis 6,
/// then those of the upper body, trunk and neck with the limits of people.
std::span<const PoseGene> whole_body_genes();

/// The 18 genes of the character of appendix A, in the order of sim::waist_up_joints(): an angle of
/// each axis that a joint turns about, within its limits.
std::span<const PoseGene> waist_up_genes();
/// Returns the pose that they stand for, balanced over the feet of `start`.
motion::Pose waist_up_pose_of(const motion::Figure& figure, const motion::Pose& start,
                              std::span<const Gene> values, GeneMap map = GeneMap::limits);

/// Returns the standing pose with what the genes of a table stand for, balanced over the feet of
/// `start`, which stands there. `values` has one gene for each of `genes`. Half of the trunk's
/// angles go to the abdomen and half of the neck's to the neck. Of the pelvis, which has no limits,
/// there must be no genes with GeneMap::full_turn.
motion::Pose pose_of(const motion::Figure& figure, const motion::Pose& start,
                     std::span<const PoseGene> genes, std::span<const Gene> values,
                     GeneMap map = GeneMap::limits);

}  // namespace flinch::evolve
