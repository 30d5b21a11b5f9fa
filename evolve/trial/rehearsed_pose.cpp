// SPDX-License-Identifier: MIT
#include "evolve/trial/rehearsed_pose.h"

#include <utility>

namespace flinch::evolve {

std::shared_ptr<const RehearsedPose> RehearsedPoses::find(const Chromosome& chromosome) const {
  const auto found = poses_.find(chromosome);
  return found == poses_.end() ? nullptr : found->second;
}

void RehearsedPoses::add(const Chromosome& chromosome, std::shared_ptr<const RehearsedPose> pose) {
  if (poses_.size() < max_count_) poses_.emplace(chromosome, std::move(pose));
}

void RehearsedPoses::keep_only(std::span<const Chromosome> chromosomes) {
  std::map<Chromosome, std::shared_ptr<const RehearsedPose>> kept;
  for (const Chromosome& chromosome : chromosomes)
    if (auto node = poses_.extract(chromosome)) kept.insert(std::move(node));
  poses_ = std::move(kept);
}

}  // namespace flinch::evolve
