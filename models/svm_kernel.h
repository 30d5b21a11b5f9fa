// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/clip_mask.h"
#include "models/svm.h"

namespace flinch::models {

/// Kernel values, in float, of one point and the support vectors of some classes of a model.
class KernelValues {
 public:
  /// `scaled` has the model's feature_count values. The model must outlive this object.
  KernelValues(const SvmModel& model, std::span<const double> scaled,
               std::span<const std::size_t> classes, MemoryResource memory);

  /// Upper bound on the difference between any value and the one computed in double. Infinite where
  /// float might overflow.
  double error() const { return error_; }

  /// Returns the values of one class, by index in the class.
  const float* of_class(std::size_t one) const { return value_.data() + first_of_class_[one]; }

 private:
  void evaluate(std::size_t begin, std::size_t end, float* values) const;

  const SvmModel& model_;
  double error_;
  std::pmr::vector<float> x_;  ///< the point, padded with zeros like the model's vectors
  /// index into `value_`, for the requested classes only
  std::pmr::vector<std::size_t> first_of_class_;
  /// Values of the requested classes, contiguous so that those of a mask fit into the L1 cache.
  std::pmr::vector<float> value_;
};

}  // namespace flinch::models
