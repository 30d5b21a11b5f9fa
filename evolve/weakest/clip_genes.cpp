// SPDX-License-Identifier: MIT
#include "evolve/weakest/clip_genes.h"

#include <algorithm>

#include "evolve/trial/pose_genes.h"

namespace flinch::evolve {

std::size_t clip_gene_count() {
  return whole_body_genes().size() + 1;
}

PacedPose paced_pose_of(const motion::Figure& figure, const motion::Pose& start,
                        const Chromosome& chromosome, double longest_s) {
  const std::span genes(chromosome);
  PacedPose paced;
  paced.pose = pose_of(figure, start, whole_body_genes(), genes.first(genes.size() - 1));
  paced.time_s = std::max(move_time_s(figure, start, paced.pose),
                          value_of(chromosome.back(), {kMinMove_s, longest_s}));
  return paced;
}

}  // namespace flinch::evolve
