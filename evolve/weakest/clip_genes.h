// SPDX-License-Identifier: MIT
#pragma once

#include "evolve/genetic/chromosome.h"
#include "evolve/run/evolved_clip.h"

namespace flinch::evolve {

/// The genes of a clip: whole_body_genes(), and a last one for its pace.
std::size_t clip_gene_count();

/// The pose that a clip's genes stand for, and the time to it: at most `longest_s`, unless no human
/// joint is that fast.
PacedPose paced_pose_of(const motion::Figure& figure, const motion::Pose& start,
                        const Chromosome& chromosome, double longest_s);

}  // namespace flinch::evolve
