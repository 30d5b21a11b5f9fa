// SPDX-License-Identifier: MIT
#pragma once

#include "train/realism/realism_fit.h"

namespace flinch::train {

/// How well estimates agree with labels that they were not fitted to.
struct RealismAgreement {
  std::size_t count = 0;    ///< of labels
  double agreement = 0;     ///< share for which both or neither are above 0.5
  double chance = 0;        ///< agreement of always saying what most labels say
  double auc = 0;           ///< chance that a label above 0.5 has a higher estimate than one below
  double baseline_auc = 0;  ///< the same of the nearness of C_t and C^i, which others use
};

/// The chance that a good one of these has a higher score than a bad one; ties count half. 0.5
/// where all are alike.
double area_under_curve(std::span<const float> scores, const std::vector<bool>& is_good);

/// Estimates every sitting's labels from the others' and compares. With `most_labels` only so many
/// labels (every k-th) of the others are used. There must be two sittings.
RealismAgreement held_out_agreement(const LabelledConfigurations& all, RealismKind kind,
                                    std::size_t most_labels = models::kMaxRealismExamples);

}  // namespace flinch::train
