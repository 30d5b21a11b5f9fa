// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/clip_mask.h"
#include "models/svm.h"

namespace flinch::models {

/// The kernel's values of one point and the vectors of some classes of a model, in float.
class KernelValues {
 public:
  /// `scaled` has the model's feature_count values. The model outlives this.
  KernelValues(const SvmModel& model, std::span<const double> scaled,
               std::span<const std::size_t> classes, MemoryResource memory);

  /// How far a value may lie from the one that double gives, whichever vector it is of. Infinite
  /// where float might overflow.
  double error() const { return error_; }

  /// The values of one of the classes, by index in the class.
  const float* of_class(std::size_t one) const { return value_.data() + first_of_class_[one]; }

 private:
  void evaluate(std::size_t begin, std::size_t end, float* values) const;

  const SvmModel& model_;
  double error_;
  std::pmr::vector<float> x_;  ///< the point, filled up with zeros as the model's vectors are
  std::pmr::vector<std::size_t> first_of_class_;  ///< in `value_`, of the asked classes alone
  /// The asked classes' one after the other, so that those of a mask stay in the first cache.
  std::pmr::vector<float> value_;
};

}  // namespace flinch::models
