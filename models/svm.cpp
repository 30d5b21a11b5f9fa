// SPDX-License-Identifier: MIT
#include "models/svm.h"

#include <algorithm>
#include <cstddef>

namespace flinch::models {
namespace {

/// base^exponent by repeated squaring: the very multiplications that libsvm does.
double power(double base, int exponent) {
  double result = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) {
      result *= base;
    }
    base *= base;
  }
  return result;
}

/// K(scaled, vector) of the vectors [first, first + kernel.size()). Each dot product is summed from
/// the first feature to the last, as libsvm sums it; the loop inside runs over vectors.
void evaluate_kernel(const SvmModel& model, std::span<const double> scaled, std::size_t first,
                     std::span<double> kernel) {
  const auto vector_count = static_cast<std::size_t>(model.vector_count());
  std::fill(kernel.begin(), kernel.end(), 0.0);
  for (std::size_t feature = 0; feature < scaled.size(); ++feature) {
    const double x = scaled[feature];
    const double* vectors = &model.support_vectors[feature * vector_count + first];
    for (std::size_t i = 0; i < kernel.size(); ++i) {
      kernel[i] += x * vectors[i];
    }
  }
  for (double& value : kernel) {
    value = power(model.gamma * value + model.coef0, model.degree);
  }
}

}  // namespace

// The machine of classes i < j decides for i where
//   sum over i's vectors of coefficient K + sum over j's vectors of coefficient K > rho.
// libsvm adds the terms of one machine after another; here the vectors are the outer loop and all
// machines of their class the inner one, which adds the same terms to each sum in the same order.
void vote(const SvmModel& model, std::span<const double> scaled, std::span<const char> allowed,
          std::span<int> votes, Memory memory) {
  std::fill(votes.begin(), votes.end(), 0);
  const std::size_t classes = model.label.size();
  if (classes < 2) {
    return;
  }
  const std::size_t machines = classes - 1;  // of one class
  std::pmr::vector<double> sums(classes * machines, 0.0, memory);
  const int most_vectors =
      *std::max_element(model.vectors_of_class.begin(), model.vectors_of_class.end());
  std::pmr::vector<double> kernel_of_class(static_cast<std::size_t>(most_vectors), memory);
  std::size_t first = 0;
  for (std::size_t c = 0; c < classes; ++c) {
    const auto count = static_cast<std::size_t>(model.vectors_of_class[c]);
    if (allowed[c]) {
      double* own = &sums[c * machines];
      for (std::size_t lower = 0; lower < c; ++lower) {
        own[lower] = sums[lower * machines + c - 1];
      }
      const auto kernel = std::span(kernel_of_class).first(count);
      evaluate_kernel(model, scaled, first, kernel);
      for (std::size_t vector = 0; vector < count; ++vector) {
        const double* coefficients = &model.coefficients[(first + vector) * machines];
        for (std::size_t machine = 0; machine < machines; ++machine) {
          own[machine] += coefficients[machine] * kernel[vector];
        }
      }
    }
    first += count;
  }
  std::size_t pair = 0;
  for (std::size_t i = 0; i < classes; ++i) {
    for (std::size_t j = i + 1; j < classes; ++j, ++pair) {
      if (allowed[i] && allowed[j]) {
        ++votes[sums[j * machines + i] - model.rho[pair] > 0 ? i : j];
      }
    }
  }
}

int predict(const SvmModel& model, std::span<const double> scaled) {
  const std::vector<char> allowed(model.label.size(), 1);
  std::vector<int> votes(model.label.size());
  vote(model, scaled, allowed, votes);
  return static_cast<int>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

}  // namespace flinch::models
