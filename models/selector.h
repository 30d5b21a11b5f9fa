// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "features/feature_layout.h"
#include "features/known_kind.h"
#include "models/candidate.h"
#include "models/knn.h"
#include "models/network.h"
#include "models/pairwise_linear.h"
#include "models/realism.h"
#include "models/response_costs.h"
#include "models/svm.h"
#include "motion/clip.h"

namespace flinch::models {

/// What a selector stores about one clip of its library.
struct ClipSummary {
  std::string name;
  /// Annotation of an anticipation; none for clips that are never allowed for a threat.
  std::optional<motion::Annotation> annotation;
};

/// Everything needed to classify: a model with its layout and scaling, and the clips that it
/// chooses from. `library_hash` identifies the library that a selector belongs to.
struct Selector {
  std::uint64_t library_hash = 0;
  std::vector<ClipSummary> clips;  ///< by index in the library
  int idle = 0;                    ///< the library's idle clip: always allowed
  features::Layout layout;         ///< of the features that it takes
  features::Scaling scaling;
  std::variant<SvmModel, KnnModel, NetworkModel, PairwiseModel> model;
  double brawn = 0.5;  ///< used for the labels that it was fitted to
  /// The kinds of threats that it was fitted to; Threat::kind is an index of these.
  std::vector<features::KnownKind> kinds = std::vector<features::KnownKind>(1);
  /// Centres of the idling character's targets, by Target, in the frame of the features, m. A
  /// threat described without a character is aimed at them.
  motion::PerTarget<Eigen::Vector3f> target_centres{
      Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(),
      Eigen::Vector3f::Zero()};
  /// What the clips cost; none in a selector that was written before files held it.
  std::optional<ResponseCosts> costs;
  /// How real pushed motions look; none where no one has judged any.
  std::optional<RealismModel> realism;
};

/// Returns the allowed clips that the model ranks, best first.
/// - SVM: all its classes, by votes, ties by the lower clip.
/// - Pairwise machines: the first `max_count` of all their clips, by votes, ties by the lower
/// index.
/// - KNN: its neighbours' labels, by votes, ties by the nearer neighbour.
/// - Network: all its clips, by expected cost, without votes.
/// - KNN that averages costs: all clips tried on its neighbours, by expected cost, without votes.
/// The first three predict no cost. Where the model knows no allowed clip, the result is the idle
/// clip alone, with neither votes nor cost; it is never empty. `scaled` has the model's
/// feature_count values.
std::pmr::vector<Candidate> candidates(const SvmModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory = std::pmr::get_default_resource(),
                                       std::size_t max_count = kNoLimit);
std::pmr::vector<Candidate> candidates(const KnnModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory = std::pmr::get_default_resource());
std::pmr::vector<Candidate> candidates(const NetworkModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory = std::pmr::get_default_resource(),
                                       std::size_t max_count = kNoLimit);
std::pmr::vector<Candidate> candidates(const PairwiseModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory = std::pmr::get_default_resource(),
                                       std::size_t max_count = kNoLimit);

/// Returns the first `max_count` (at least one) candidates of the selector's model. The fewer are
/// requested, the fewer pairs an SVM or a pairwise model has to decide. `x` is in the selector's
/// layout and not scaled.
std::pmr::vector<Candidate> candidates(const Selector& selector, const features::FeatureVector& x,
                                       motion::Target threatened,
                                       MemoryResource memory = std::pmr::get_default_resource(),
                                       std::size_t max_count = kNoLimit);

/// Returns the first candidate, in less time than it takes to rank all of them.
int select(const Selector& selector, const features::FeatureVector& x, motion::Target threatened);

/// Returns which clips are allowed for a threat at this target, by index. The idle clip always is.
ClipMask allowed_clips(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                       MemoryResource memory = std::pmr::get_default_resource());

}  // namespace flinch::models
