// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "evolve/run/evolved_clip.h"

namespace flinch::evolve {

/// Resources of a run.
struct PoseEvolution {
  GeneticOptions genetic;  ///< of which the trial's map of genes decides `ends`
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  ///< ends the run before its generation is over
  /// Called after every generation.
  std::function<void(const Evolution&)> report = [](const Evolution&) {};
};

/// Goes on with a run, or begins one, until an end condition is met. Generation k meets the balls
/// of draw k. The same options give the same bits for any number of threads and interruptions.
/// Returns false if `stop` became true first; `evolution` then holds the last whole generation.
bool evolve_poses(const PoseTrial& trial, const PoseEvolution& run, Evolution& evolution);

/// Draws that no generation meets: to tell when a run has converged, to choose among the best of
/// the last generations, and to measure the one that is chosen.
inline constexpr std::uint64_t kCheckDraw = 500'000;
inline constexpr std::uint64_t kChoiceDraw = 1'000'000;
inline constexpr std::uint64_t kUnseenDraw = 2'000'000;

/// The best pose of a run, and its clip.
struct EvolvedPose {
  Chromosome chromosome;
  PoseScore score;  ///< on the draws that it was chosen by
  EvolvedClip clip;
};

/// Tests the best of the last generations, and the next, again on fresh balls and returns the best
/// whose clip keeps every bound of database::QualityBounds. Throws Error if none does.
EvolvedPose chosen_pose(const PoseTrial& trial, const PoseEvolution& run,
                        const Evolution& evolution, const motion::Clip& idle,
                        const ClipDescription& description);

}  // namespace flinch::evolve
