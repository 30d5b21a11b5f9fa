// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "models/candidate.h"
#include "models/clip_mask.h"

namespace flinch::models {

enum class SvmKernel : std::uint8_t {
  polynomial,  ///< K(u, v) = (gamma u.v + coef0)^degree
  rbf,         ///< K(u, v) = exp(-gamma |u - v|^2)
};

/// One binary machine for classes i < j. It votes for i where
///   sum of a K(x, v) over i's vectors - sum of a K(x, v) over j's vectors > rho,
/// and for j otherwise, where a > 0 is the vector's coefficient in this machine. The coefficients
/// of bounded vectors all equal the class's bound and are not stored.
struct SvmMachine {
  double rho = 0;
  /// Number of entries in the model's `vectors` for i's free vectors, i's bounded ones, j's free
  /// ones and j's bounded ones. They are stored in this order, each group by ascending index.
  std::array<std::uint16_t, 4> count{};

  // Derived from all machines: see update_derived().
  std::uint32_t first_vector = 0;       ///< index into the model's `vectors`
  std::uint32_t first_coefficient = 0;  ///< index into the model's `coefficients`
  double weight = 0;                    ///< sum of its coefficients
};

/// A C-SVC with one machine per pair of classes, as libsvm trains it. Vectors are floats, sums are
/// double, so that decision_value() returns libsvm's own value to the bit.
///
/// Vectors of one class are contiguous, with classes in the order of `label`.
struct SvmModel {
  SvmKernel kernel = SvmKernel::polynomial;
  int degree = 3;    ///< of a polynomial kernel; so is coef0
  double gamma = 1;  ///< not negative
  double coef0 = 0;
  double cost = 1;  ///< C used for training, for the record
  int feature_count = 0;
  std::vector<int> label;             ///< clip index of each class, ascending if fit_svm made it
  std::vector<int> vectors_of_class;  ///< number of support vectors of each class
  std::vector<double> bound;  ///< largest coefficient of each class: C times the class weight
  /// One row of row_size() values per vector: its features, padded with zeros to a multiple of
  /// kLanes.
  std::vector<float> support_vectors;
  std::vector<SvmMachine> machines;    ///< of the classes (0,1), (0,2), …, (1,2), …
  std::vector<std::uint16_t> vectors;  ///< index within the class, machine by machine
  std::vector<double> coefficients;    ///< of the free vectors, machine by machine

  // Derived from the members above: see update_derived().
  std::vector<int> first_of_class{};  ///< index of each class's first vector
  double largest_norm = 0;            ///< of all support vectors

  static constexpr std::size_t kLanes = 4;

  int class_count() const { return static_cast<int>(label.size()); }
  int vector_count() const {
    return label.empty() ? 0 : first_of_class.back() + vectors_of_class.back();
  }
  static constexpr std::size_t row_size(int feature_count) {
    return (static_cast<std::size_t>(feature_count) + kLanes - 1) / kLanes * kLanes;
  }
  std::size_t row_size() const { return row_size(feature_count); }
  float value(std::size_t vector, std::size_t feature) const {
    return support_vectors[vector * row_size() + feature];
  }
};

/// Computes the derived members from the others. These must be consistent: sizes agree, and every
/// index is within its class.
void update_derived(SvmModel& model);

/// Returns the decision value of the machine for classes i < j, identical to libsvm's to the bit
/// wherever no kernel value overflows. `scaled` has feature_count values.
double decision_value(const SvmModel& model, std::span<const double> scaled, std::size_t i,
                      std::size_t j);

/// A class and the number of its votes.
struct RankedClass {
  std::size_t index = 0;  ///< in the model's class order
  int votes = 0;
};

/// Returns the first `max_count` allowed classes by the votes of the machines for pairs of allowed
/// classes: most votes first, ties by the lower index (svm_predict's rule). Evaluates only the
/// machines that this needs. They are evaluated in float, and in double by decision_value() where
/// float precision cannot decide, so that every vote equals libsvm's. `scaled` has feature_count
/// values, `allowed` class_count.
std::pmr::vector<RankedClass> rank(const SvmModel& model, std::span<const double> scaled,
                                   std::span<const char> allowed, std::size_t max_count = kNoLimit,
                                   MemoryResource memory = std::pmr::get_default_resource());

/// Returns the index of the class with the most votes among all classes, the lowest on a tie.
int predict(const SvmModel& model, std::span<const double> scaled);

}  // namespace flinch::models
