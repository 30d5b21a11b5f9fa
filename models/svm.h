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

/// What decides between classes i < j: for i where
///   sum of a K(x, v) over i's vectors - sum of a K(x, v) over j's vectors > rho,
/// for j elsewhere, with a > 0 the vector's coefficient in this machine. Vectors whose coefficient
/// is the class's bound need no number of their own.
struct SvmMachine {
  double rho = 0;
  /// How many of the model's `vectors` are i's free ones, i's at the bound, j's free ones and j's
  /// at the bound; they stand there in this order, and each of the four by rising index.
  std::array<std::uint16_t, 4> count{};

  // What follows from all machines: see complete().
  std::uint32_t first_vector = 0;       ///< in the model's `vectors`
  std::uint32_t first_coefficient = 0;  ///< in the model's `coefficients`
  double weight = 0;                    ///< sum of its coefficients
};

/// A C-SVC with one machine for each pair of classes, as libsvm trains it. Vectors are floats; what
/// is added up is double, so that decision() is libsvm's own, to the bit.
///
/// Vectors of one class stand together, classes in the order of `label`.
struct SvmModel {
  SvmKernel kernel = SvmKernel::polynomial;
  int degree = 3;    ///< of a polynomial kernel, and coef0 too
  double gamma = 1;  ///< not negative
  double coef0 = 0;
  double cost = 1;  ///< C that it was trained with, for the record
  int feature_count = 0;
  std::vector<int> label;             ///< clip index of each class, in the model's class order
  std::vector<int> vectors_of_class;  ///< number of support vectors of each class
  std::vector<double> bound;          ///< the largest coefficient of each class: C times its weight
  /// One row of row_size() values a vector: its features, filled up with zeros to whole kLanes.
  std::vector<float> support_vectors;
  std::vector<SvmMachine> machines;    ///< of the classes (0,1), (0,2), …, (1,2), …
  std::vector<std::uint16_t> vectors;  ///< index within their class; machine after machine
  std::vector<double> coefficients;    ///< of the free vectors; machine after machine

  // What follows from the above: see complete().
  std::vector<int> first_of_class{};  ///< index of each class's first vector
  double largest_norm = 0;            ///< of a support vector

  static constexpr std::size_t kLanes = 4;

  int class_count() const { return static_cast<int>(label.size()); }
  int vector_count() const {
    return label.empty() ? 0 : first_of_class.back() + vectors_of_class.back();
  }
  /// Index of the machine of classes i < j.
  std::size_t machine_of(std::size_t i, std::size_t j) const {
    return i * label.size() - i * (i + 1) / 2 + (j - i - 1);
  }
  static constexpr std::size_t row_size(int feature_count) {
    return (static_cast<std::size_t>(feature_count) + kLanes - 1) / kLanes * kLanes;
  }
  std::size_t row_size() const { return row_size(feature_count); }
  float value(std::size_t vector, std::size_t feature) const {
    return support_vectors[vector * row_size() + feature];
  }
};

/// Sets what follows from a model's other members. They fit together: sizes agree, and no index
/// lies beyond its class.
void complete(SvmModel& model);

/// The decision value of the machine of classes i < j: to the bit what libsvm computes of the same
/// numbers where no kernel value overflows. `scaled` has feature_count values.
double decision(const SvmModel& model, std::span<const double> scaled, std::size_t i,
                std::size_t j);

/// A class with the votes that it got.
struct RankedClass {
  std::size_t index = 0;  ///< in the model's order
  int votes = 0;
};

/// The allowed classes by the votes of the machines of pairs of allowed classes, most votes first,
/// ties by the lower index (svm_predict's rule): the first `most` of them. Machines are asked only
/// as far as that needs. They are asked in float, and in double by decision() where float cannot
/// tell, so that every vote is libsvm's. `scaled` has feature_count values, `allowed` class_count.
std::pmr::vector<RankedClass> rank(const SvmModel& model, std::span<const double> scaled,
                                   std::span<const char> allowed, std::size_t most = kAll,
                                   Memory memory = std::pmr::get_default_resource());

/// The class index with the most votes among all classes, the lowest on a tie.
int predict(const SvmModel& model, std::span<const double> scaled);

}  // namespace flinch::models
