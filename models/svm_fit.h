// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "models/svm.h"
#include "models/training_set.h"

namespace flinch::models {

/// What a C-SVC with a polynomial kernel is trained with.
struct SvmParameters {
  int degree = 3;
  double gamma = 1;
  double coef0 = 0;
  double cost = 1;  ///< C

  bool operator==(const SvmParameters&) const = default;
};

/// libsvm's own: degree 3, gamma 1 / feature_count, coef0 0, C 1.
SvmParameters default_svm_parameters(int feature_count);

/// The parameters to choose from by cross-validation, libsvm's defaults first: degree 2 and 3,
/// gamma once and four times 1 / feature_count, coef0 0 and 1, C 1, 10 and 100.
std::vector<SvmParameters> svm_grid(int feature_count);

/// Trains with libsvm (stopping tolerance 0.001, shrinking), to the same bits as `svm-train -t 1`
/// on the same numbers. Classes stand in libsvm's order: by first appearance in the set. Throws
/// Error for what check() refuses and for parameters that libsvm refuses.
SvmModel fit_svm(const TrainingSet& set, const SvmParameters& parameters);

}  // namespace flinch::models
