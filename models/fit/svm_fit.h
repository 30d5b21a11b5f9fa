// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/fit/training_set.h"
#include "models/svm.h"

namespace flinch::models {

/// What a C-SVC is trained with.
struct SvmParameters {
  int degree = 3;  ///< of a polynomial kernel, and coef0 too
  double gamma = 1;
  double coef0 = 0;
  double cost = 1;  ///< C
  SvmKernel kernel = SvmKernel::polynomial;
  /// How far rare classes are weighed up, from 0 to 1: C of a class of n of N observations in K
  /// classes is multiplied by (N / (K n))^balance.
  double balance = 0;

  bool operator==(const SvmParameters&) const = default;
};

/// libsvm's own: degree 3, gamma 1 / feature_count, coef0 0, C 1.
SvmParameters default_svm_parameters(int feature_count);

/// The parameters to choose from by cross-validation, with C 10, 100 and 1000. Polynomial: libsvm's
/// defaults first, then degree 2 and 3 with coef0 0, and with coef0 1 and gamma once and four times
/// 1 / feature_count. RBF: gamma a quarter of, once and four times 1 / feature_count. None with
/// balance: on the default library it did not have the least regret.
std::vector<SvmParameters> svm_grid(int feature_count, SvmKernel kernel = SvmKernel::polynomial);

/// A model of what libsvm's svm_train found: classes with their clips, C and number of vectors, the
/// vectors' values row by row, one row of class_count - 1 values a vector with libsvm's sv_coef of
/// it, and rho of each pair. Values are kept as floats. Throws Error for a class of more than
/// 65,535 vectors.
SvmModel make_svm_model(const SvmParameters& parameters, std::vector<int> label,
                        std::vector<int> vectors_of_class, std::vector<double> bound,
                        std::span<const double> values, int feature_count,
                        std::span<const double> coefficients, std::span<const double> rho);

/// Trains with libsvm (stopping tolerance 0.001, shrinking), pair by pair of classes on OpenMP's
/// threads: to the same bits as `svm-train` on the same numbers, for any number of threads. The
/// points are rounded to floats first, as the model keeps them. Classes stand in libsvm's order: by
/// first appearance in the set; the bits depend on the observations' order, which is by scenario
/// number throughout the program. Throws Error for what check() refuses and for parameters that
/// libsvm refuses.
SvmModel fit_svm(const TrainingSet& set, const SvmParameters& parameters);

}  // namespace flinch::models
