// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "train/realism/realism_fit.h"

namespace flinch::train {

/// How well estimates have agreed with the last answers of a judge.
struct RecentAgreement {
  std::size_t count = 0;   ///< of answers that were estimated before, at most kRecentAnswers
  double same_side = 0;    ///< share of which both or neither are above 0.5
  double mean_error = 0;   ///< of the estimate
  bool is_enough = false;  ///< the judge may stop: see agrees()
};

/// Answers that count as the last ones.
inline constexpr std::size_t kRecentAnswers = 50;

/// The interactive loop of Arikan et al. 2005, section 5.1: draws a motion, estimates how good it
/// will look, takes the judge's answer, fits G again, draws the next.
///
/// Each answer changes components, scales and examples at once. The factors of groups, which take
/// the longest to choose, are chosen anew when the labels have grown by a tenth.
class Labelling {
 public:
  /// `responses` must outlive it and not be empty. The same seed draws the same motions.
  Labelling(const runtime::PushResponses& responses, std::uint64_t seed);

  /// Takes labels of earlier sittings or other judges.
  void add(std::span<const Label> labels);
  /// Draws the next motion and estimates it; none with too few labels.
  void next();
  const PushExample& example() const { return example_; }
  std::optional<float> estimate() const { return estimate_; }
  /// Takes the judge's answer to example(), 0 to 1, and fits again.
  void judge(float quality);

  std::size_t label_count() const { return all_.labels.size(); }
  const RecentAgreement& agreement() const { return agreement_; }
  /// G of all labels so far; none with too few.
  const std::optional<models::RealismModel>& model() const { return model_; }

 private:
  void fit();

  const runtime::PushResponses& responses_;
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
  LabelledConfigurations all_;
  std::optional<models::RealismModel> model_;
  RealismFactors factors_;
  std::size_t fitted_count_ = 0;  // of labels when the factors were chosen
  PushExample example_;
  std::optional<float> estimate_;
  struct Answer {
    float estimate;
    float quality;
  };
  std::deque<Answer> recent_;
  RecentAgreement agreement_;
};

/// Whether estimate and judge agree: of kRecentAnswers at least 85 % on the same side of 0.5, a
/// mean error of at most 0.15, and at least five of either side, since always saying "bad" is no
/// agreement.
bool agrees(std::size_t count, double same_side, double mean_error, std::size_t good);

}  // namespace flinch::train
