// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "features/feature_vector.h"
#include "models/knn.h"
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
  std::vector<std::string> feature_names;
  features::Scaling scaling;
  std::variant<SvmModel, KnnModel> model;
  double brawn = 0.1;  ///< that its labels were made with
};

/// One clip that a selector considered, with how strongly it is for it.
struct Candidate {
  int clip = 0;    ///< the library's index
  float vote = 0;  ///< share of the votes cast, in [0, 1]
};

/// The allowed clips that the model knows, best first: more votes, then the lower index as the
/// model's own tie rule has it. Never empty: the idle clip is the last resort. `x` is not scaled.
std::vector<Candidate> candidates(const Selector& selector, const features::FeatureVector& x,
                                  motion::Target threatened);

/// The first of the candidates.
int select(const Selector& selector, const features::FeatureVector& x, motion::Target threatened);

/// Which clips are allowed for a threat at this target, by index; the idle clip always is.
std::vector<bool> allowed_clips(std::span<const ClipSummary> clips, int idle,
                                motion::Target threatened);

}  // namespace flinch::models
