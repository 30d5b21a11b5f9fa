// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/clip_mask.h"

namespace flinch::models {

/// A C-SVC with a polynomial kernel K(u, v) = (gamma u.v + coef0)^degree and one machine for each
/// pair of classes, as libsvm trains it. Double precision throughout, so that predictions are
/// libsvm's own.
///
/// Vectors of one class stand together, classes in the order of `label`.
struct SvmModel {
  int degree = 3;
  double gamma = 1;
  double coef0 = 0;
  double cost = 1;  ///< C that it was trained with, for the record
  int feature_count = 0;
  std::vector<int> label;             ///< clip index of each class, in the model's class order
  std::vector<int> vectors_of_class;  ///< number of support vectors of each class
  /// feature_count rows of one value a support vector, so that the kernel of many vectors is
  /// evaluated at once.
  std::vector<double> support_vectors;
  /// vector_count rows of class_count - 1 values: libsvm's sv_coef, transposed. Of a vector of
  /// class c, value r belongs to the machine of c and class r, or r + 1 where r >= c.
  std::vector<double> coefficients;
  std::vector<double> rho;  ///< one a pair of classes (0,1), (0,2), …, (1,2), …

  int class_count() const { return static_cast<int>(label.size()); }
  int vector_count() const {
    return feature_count == 0 ? 0 : static_cast<int>(support_vectors.size()) / feature_count;
  }
};

/// Votes for each class by the pairwise machines, of pairs of allowed classes only. `scaled` has
/// feature_count values, `allowed` and `votes` class_count.
void vote(const SvmModel& model, std::span<const double> scaled, std::span<const char> allowed,
          std::span<int> votes, Memory memory = std::pmr::get_default_resource());

/// The class index with the most votes among all classes, the lowest on a tie: svm_predict's rule.
int predict(const SvmModel& model, std::span<const double> scaled);

}  // namespace flinch::models
