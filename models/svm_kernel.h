// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "models/clip_mask.h"
#include "models/svm.h"

namespace flinch::models {

/// The kernel's values of one point and a model's vectors, in float, each computed when it is first
/// asked for: a choice asks for a third of them.
class LazyKernel {
 public:
  /// `scaled` has the model's feature_count values. The model outlives this.
  LazyKernel(const SvmModel& model, std::span<const double> scaled, Memory memory);

  /// How far a value may lie from the one that double gives, whichever vector it is of. Infinite
  /// where float might overflow.
  double error() const { return error_; }

  /// The values of one class by index in the class, of which those in `vectors` are there. These
  /// are of a machine's list: no more than the class has.
  const float* values(std::size_t one, std::span<const std::uint16_t> vectors);

 private:
  void evaluate(std::size_t first, std::span<const std::uint16_t> vectors);

  const SvmModel& model_;
  double error_;
  std::pmr::vector<float> x_;      ///< the point, filled up with zeros as the model's vectors are
  std::pmr::vector<float> value_;  ///< by vector; not a number where it was not asked for
  std::pmr::vector<std::uint16_t> missing_;  ///< room for the longest list
};

}  // namespace flinch::models
