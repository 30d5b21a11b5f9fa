// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "models/fit/knn_fit.h"
#include "models/fit/pairwise_linear_fit.h"
#include "models/fit/svm_fit.h"

namespace flinch::train {

/// Parameters of a method that are given rather than chosen by cross-validation.
struct FixedParameters {
  std::optional<int> k{};         ///< number of neighbours: knn, knn_cost
  std::optional<double> c{};      ///< C: svm, svm_rbf, pairwise_cost
  std::optional<double> gamma{};  ///< of the kernel: svm, svm_rbf
  std::optional<int> degree{};    ///< of the polynomial kernel: svm
  std::optional<double> coef0{};  ///< of the polynomial kernel: svm
  bool libsvm_defaults = false;   ///< what is not given above is as libsvm has it: svm, svm_rbf

  bool operator==(const FixedParameters&) const = default;
};

/// Return a grid's candidates with the given values in place of their own, each candidate once, in
/// the grid's order. So cross-validation chooses what is not given. Parameters that the grid does
/// not have are ignored.
std::vector<models::KnnParameters> narrow(std::vector<models::KnnParameters> grid,
                                          const FixedParameters& fixed);
std::vector<models::SvmParameters> narrow(std::vector<models::SvmParameters> grid,
                                          const FixedParameters& fixed, int feature_count);
std::vector<models::PairwiseParameters> narrow(std::vector<models::PairwiseParameters> grid,
                                               const FixedParameters& fixed);

}  // namespace flinch::train
