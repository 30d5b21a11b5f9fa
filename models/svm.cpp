// SPDX-License-Identifier: MIT
#include "models/svm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "models/integer_power.h"
#include "models/pair_index.h"

namespace flinch::models {
namespace {

/// K(scaled, vector), with the same operations in the same order as libsvm.
double kernel(const SvmModel& model, std::span<const double> scaled, std::size_t vector) {
  double sum = 0;
  if (model.kernel == SvmKernel::polynomial) {
    for (std::size_t f = 0; f < scaled.size(); ++f) {
      sum += scaled[f] * double{model.value(vector, f)};
    }
    return integer_power(model.gamma * sum + model.coef0, model.degree);
  }
  for (std::size_t f = 0; f < scaled.size(); ++f) {
    const double difference = scaled[f] - double{model.value(vector, f)};
    sum += difference * difference;
  }
  return std::exp(-model.gamma * sum);
}

double norm(const SvmModel& model, std::size_t vector) {
  double sum = 0;
  for (std::size_t f = 0; f < static_cast<std::size_t>(model.feature_count); ++f) {
    const double value = model.value(vector, f);
    sum += value * value;
  }
  return std::sqrt(sum);
}

}  // namespace

void update_derived(SvmModel& model) {
  model.first_of_class.assign(model.label.size(), 0);
  std::exclusive_scan(model.vectors_of_class.begin(), model.vectors_of_class.end(),
                      model.first_of_class.begin(), 0);
  model.largest_norm = 0;
  for (int vector = 0; vector < model.vector_count(); ++vector) {
    model.largest_norm =
        std::max(model.largest_norm, norm(model, static_cast<std::size_t>(vector)));
  }
  std::uint32_t first_vector = 0;
  std::uint32_t first_coefficient = 0;
  for (std::size_t i = 0; i < model.label.size(); ++i) {
    for (std::size_t j = i + 1; j < model.label.size(); ++j) {
      SvmMachine& machine = model.machines[pair_index(i, j, model.label.size())];
      const auto& [free_i, bound_i, free_j, bound_j] = machine.count;
      machine.first_vector = first_vector;
      machine.first_coefficient = first_coefficient;
      machine.weight = bound_i * model.bound[i] + bound_j * model.bound[j];
      for (int k = 0; k < free_i + free_j; ++k) {
        machine.weight += model.coefficients[first_coefficient++];
      }
      first_vector += static_cast<std::uint32_t>(free_i + bound_i + free_j + bound_j);
    }
  }
}

// libsvm adds the terms of i's vectors by ascending index, then those of j's. Here the free and the
// bounded vectors are merged back into that order.
double decision_value(const SvmModel& model, std::span<const double> scaled, std::size_t i,
                      std::size_t j) {
  const SvmMachine& machine = model.machines[pair_index(i, j, model.label.size())];
  const std::uint16_t* next = model.vectors.data() + machine.first_vector;
  const double* coefficient = model.coefficients.data() + machine.first_coefficient;
  double sum = 0;
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const std::size_t one = side == 0 ? i : j;
    const double sign = side == 0 ? 1 : -1;
    const auto first = static_cast<std::size_t>(model.first_of_class[one]);
    const std::uint16_t* const free_end = next + machine.count[2 * side];
    const std::uint16_t* bound = free_end;
    const std::uint16_t* const bound_end = bound + machine.count[2 * side + 1];
    while (next != free_end || bound != bound_end) {
      const bool is_free = bound == bound_end || (next != free_end && *next < *bound);
      const double a = is_free ? *coefficient++ : model.bound[one];
      sum += sign * a * kernel(model, scaled, first + (is_free ? *next++ : *bound++));
    }
    next = bound_end;
  }
  return sum - machine.rho;
}

int predict(const SvmModel& model, std::span<const double> scaled) {
  const std::vector<char> allowed(model.label.size(), 1);
  return static_cast<int>(rank(model, scaled, allowed, 1).front().index);
}

}  // namespace flinch::models
