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
#include "models/candidate.h"
#include "models/knn.h"
#include "models/network.h"
#include "models/pairwise_linear.h"
#include "models/svm.h"
#include "motion/clip.h"

namespace flinch::models {

/// What a selector knows of one clip of its library.
struct ClipSummary {
  std::string name;
  /// Of an anticipation; none for clips that no threat allows.
  std::optional<motion::Annotation> annotation;
};

/// Everything needed to classify: a model with its layout and scaling, and the clips that it
/// chooses from. Selector and library belong together by `library_hash`.
struct Selector {
  std::uint64_t library_hash = 0;
  std::vector<ClipSummary> clips;  ///< by the library's index
  int idle = 0;                    ///< the library's idle clip: always allowed
  features::Layout layout;         ///< of the features that it is asked with
  features::Scaling scaling;
  std::variant<SvmModel, KnnModel, NetworkModel, PairwiseModel> model;
  double brawn = 0.1;  ///< that its labels were made with
  /// Centres of the targets of the idling character, by Target, in the frame of the features, m:
  /// where a threat described without a character aims.
  std::array<Eigen::Vector3f, motion::kTargetCount> target_centres{
      Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(),
      Eigen::Vector3f::Zero()};
};

/// The allowed clips that the model votes among, best first. An SVM's are all its classes, ranked
/// by votes, ties by the model's class order; those of pairwise machines the first `most` of all
/// their clips, ranked by votes, ties by the lower index; a KNN's are its neighbours' labels,
/// ranked by votes, ties by the nearer neighbour. None of these expects a cost. A network's are the
/// first `most` of all its clips, and those of a KNN that averages costs all that were tried on its
/// neighbours, ranked by expected cost, with no votes. Where the model knows no allowed clip the
/// idle clip is the last resort, with neither: never empty. `scaled` has the model's feature_count
/// values.
std::pmr::vector<Candidate> candidates(const SvmModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       Memory memory = std::pmr::get_default_resource(),
                                       std::size_t most = kAll);
std::pmr::vector<Candidate> candidates(const KnnModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       Memory memory = std::pmr::get_default_resource());
std::pmr::vector<Candidate> candidates(const NetworkModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       Memory memory = std::pmr::get_default_resource(),
                                       std::size_t most = kAll);
std::pmr::vector<Candidate> candidates(const PairwiseModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       Memory memory = std::pmr::get_default_resource(),
                                       std::size_t most = kAll);

/// The candidates of the selector's model, the first `most` of them and at least one: the fewer are
/// asked for, the fewer pairs an SVM or a model of pairwise machines has to decide. `x` is in the
/// selector's layout and not scaled.
std::pmr::vector<Candidate> candidates(const Selector& selector, const features::FeatureVector& x,
                                       motion::Target threatened,
                                       Memory memory = std::pmr::get_default_resource(),
                                       std::size_t most = kAll);

/// The first of the candidates, in less time than all of them take.
int select(const Selector& selector, const features::FeatureVector& x, motion::Target threatened);

/// Which clips are allowed for a threat at this target, by index; the idle clip always is.
ClipMask allowed_clips(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                       Memory memory = std::pmr::get_default_resource());

}  // namespace flinch::models
