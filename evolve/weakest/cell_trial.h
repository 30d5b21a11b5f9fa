// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>

#include "evolve/genetic/evolution.h"
#include "evolve/run/evolved_clip.h"
#include "evolve/weakest/threat_cell.h"
#include "train/objective/cost.h"
#include "train/simulate/batch.h"

namespace flinch::evolve {

/// What a clip does for an oracle, on average over some threats. Less is better.
struct ClipScore {
  double oracle_ns = 0;  ///< cost of the oracle's choice if it can choose the clip too
  double cost_ns = 0;    ///< of the clip
  /// Penalty for each broken bound of database::QualityBounds and for arms inside the body.
  double flaws_ns = 0;

  /// What the clip itself costs counts too, though little: it leads from clips that the oracle
  /// never chooses to those that it does.
  double fitness() const {
    constexpr double kOwnShare = 0.1;
    return oracle_ns + kOwnShare * cost_ns + flaws_ns;
  }
};

/// What clips are tested with. The library must stay in place.
struct CellTrialSetup {
  const database::ClipLibrary& library;
  train::SimulationPlan plan;  ///< of all threats
  train::CostModel cost_model;
  int threads = 1;
};

/// Tests clips as answers to the threats of one cell, beside those of a library: by the responses,
/// simulations and costs of training, but with one phase of the idle clip, which hardly matters.
class CellTrial {
 public:
  /// The cell must have threats.
  CellTrial(const CellTrialSetup& setup, const ThreatCell& cell);

  /// Tests chromosomes of clip_gene_count() genes on a range of the cell's scenarios, the same for
  /// all. Independent of the number of threads to the last bit. Returns nothing if `stop` became
  /// true first.
  std::optional<std::vector<ClipScore>> test(std::span<const Chromosome> chromosomes,
                                             train::ScenarioRange range,
                                             const std::atomic<bool>* stop = nullptr);

  /// Returns the clip of a chromosome.
  EvolvedClip clip(const Chromosome& chromosome, const ClipDescription& description) const;
  /// Work of the clip's response with unlimited time, J.
  double reference_work_j(const motion::Clip& clip) const;

 private:
  bool know_oracle(train::ScenarioRange range, const std::atomic<bool>* stop);
  PacedPose paced_pose(const Chromosome& chromosome) const;
  /// Returns a library of the idle clip and no other.
  database::ClipLibrary idle_library() const;
  /// Adds the clips of chromosomes to a library, and returns the penalty for the flaws of each.
  std::vector<double> add_clips(std::span<const Chromosome> chromosomes,
                                database::ClipLibrary& library) const;

  const database::ClipLibrary& library_;
  ThreatCell cell_;
  train::SimulationPlan plan_;  ///< of the cell's threats
  train::CostModel cost_model_;
  int threads_;
  motion::Figure figure_;
  double longest_s_;                                     ///< time to a pose
  std::unique_ptr<const train::SimulationSetup> setup_;  ///< of the library, once needed
  train::RehearsalCache rehearsals_;
  std::map<std::uint64_t, double> oracle_ns_;  ///< with the library alone, by scenario
};

}  // namespace flinch::evolve
