// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "evolve/genetic/chromosome.h"
#include "sim/rehearsal/rehearsal.h"

namespace flinch::evolve {

/// A pose that has moved without a ball, ready for those of any draw.
struct RehearsedPose {
  std::vector<sim::Rehearsal> rehearsals;  ///< one per failure
  std::vector<double> efforts;             ///< of each, N m s
  double overlap_penalty = 0;              ///< N·s
};

/// Remembers rehearsed poses from one test to the next: the better half of a generation meets other
/// balls in the next, but moves as before. About 0.4 MiB each.
class RehearsedPoses {
 public:
  /// Remembers at most `max_count`; others are rehearsed again, with the same results.
  explicit RehearsedPoses(std::size_t max_count = 512) : max_count_(max_count) {}

  /// The pose of a chromosome; null if it is not remembered.
  std::shared_ptr<const RehearsedPose> find(const Chromosome& chromosome) const;
  /// Remembers a pose while there is room.
  void add(const Chromosome& chromosome, std::shared_ptr<const RehearsedPose> pose);
  /// Forgets all others.
  void keep_only(std::span<const Chromosome> chromosomes);

 private:
  std::size_t max_count_;
  std::map<Chromosome, std::shared_ptr<const RehearsedPose>> poses_;
};

}  // namespace flinch::evolve
