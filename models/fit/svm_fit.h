// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/fit/training_set.h"
#include "models/svm.h"

namespace flinch::models {

/// Parameters of training a C-SVC.
struct SvmParameters {
  int degree = 3;  ///< of a polynomial kernel; so is coef0
  double gamma = 1;
  double coef0 = 0;
  double cost = 1;  ///< C
  SvmKernel kernel = SvmKernel::polynomial;
  /// How much rare classes are weighted up, from 0 to 1: the C of a class with n of N observations
  /// in K classes is multiplied by (N / (K n))^balance.
  double balance = 0;

  bool operator==(const SvmParameters&) const = default;
};

/// Returns libsvm's defaults: degree 3, gamma 1 / feature_count, coef0 0, C 1.
SvmParameters default_svm_parameters(int feature_count);

/// Returns the parameters for cross-validation, each with C 10, 100 and 1000. Polynomial: libsvm's
/// defaults first, then degree 2 and 3 with coef0 0, and with coef0 1 and gamma 1 and 4 times 1 /
/// feature_count. RBF: gamma 0.25, 1 and 4 times 1 / feature_count. None uses balance: on the
/// default library it did not give the lowest regret.
std::vector<SvmParameters> svm_grid(int feature_count, SvmKernel kernel = SvmKernel::polynomial);

/// Makes a model from a result of libsvm's svm_train: classes with their clips, C and number of
/// vectors; the vectors' values row by row; one row of class_count - 1 values per vector with its
/// sv_coef; and rho of each pair. Values are stored as floats. Throws Error for a class of more
/// than 65,535 vectors.
SvmModel make_svm_model(const SvmParameters& parameters, std::vector<int> label,
                        std::vector<int> vectors_of_class, std::vector<double> bound,
                        std::span<const double> values, int feature_count,
                        std::span<const double> coefficients, std::span<const double> rho);

/// Trains with libsvm (stopping tolerance 0.001, shrinking), one pair of classes at a time, in
/// parallel on OpenMP's threads. Points are first rounded to floats, as the model stores them.
/// Classes are in ascending order of their clips, so a tie of votes goes to the lower clip,
/// whichever was seen first. The result equals that of `svm-train` on the observations sorted by
/// label to the bit, for any number of threads. The bits depend on the order of observations within
/// a class, which is by scenario number throughout the program. Throws Error for a set that check()
/// rejects and for parameters that libsvm rejects.
SvmModel fit_svm(const TrainingSet& set, const SvmParameters& parameters);

}  // namespace flinch::models
