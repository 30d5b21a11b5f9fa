// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "models/pair_index.h"
#include "models/svm.h"
#include "models/svm_kernel.h"
#include "models/tournament.h"

namespace flinch::models {
namespace {

std::pmr::vector<std::size_t> classes_of(std::span<const char> allowed, MemoryResource memory) {
  std::pmr::vector<std::size_t> classes(memory);
  classes.reserve(allowed.size());
  for (std::size_t c = 0; c < allowed.size(); ++c) {
    if (allowed[c]) classes.push_back(c);
  }
  return classes;
}

/// Decisions of the machines of some classes for one point.
class PairDecisions {
 public:
  PairDecisions(const SvmModel& model, std::span<const double> scaled,
                std::span<const std::size_t> classes, MemoryResource memory)
      : model_(model), scaled_(scaled), kernel_(model, scaled, classes, memory) {}

  /// Returns whether class i < j is preferred to j.
  bool is_first_preferred(std::size_t i, std::size_t j) const {
    const SvmMachine& machine = model_.machines[pair_index(i, j, model_.label.size())];
    const std::uint16_t* vector = model_.vectors.data() + machine.first_vector;
    const double* coefficient = model_.coefficients.data() + machine.first_coefficient;
    const double first = kernel_sum(i, machine.count[0], machine.count[1], vector, coefficient);
    const double second = kernel_sum(j, machine.count[2], machine.count[3], vector, coefficient);
    const double value = first - second - machine.rho;
    // NaN fails this comparison, so it too is decided in double.
    if (std::abs(value) > machine.weight * kernel_.error()) return value > 0;
    return decision_value(model_, scaled_, i, j) > 0;
  }

 private:
  /// Sum of a K over one side's vectors, the free ones first; advances the pointers to the other
  /// side's.
  double kernel_sum(std::size_t one, std::uint16_t free_count, std::uint16_t bound_count,
                    const std::uint16_t*& vector, const double*& coefficient) const {
    const float* kernel = kernel_.of_class(one);
    std::array<double, 2> free{};
    std::array<double, 2> bound{};
    int k = 0;
    for (; k + 1 < free_count; k += 2) {
      free[0] += coefficient[k] * double{kernel[vector[k]]};
      free[1] += coefficient[k + 1] * double{kernel[vector[k + 1]]};
    }
    if (k < free_count) free[0] += coefficient[k] * double{kernel[vector[k]]};
    vector += free_count;
    coefficient += free_count;
    for (k = 0; k + 1 < bound_count; k += 2) {
      bound[0] += double{kernel[vector[k]]};
      bound[1] += double{kernel[vector[k + 1]]};
    }
    if (k < bound_count) bound[0] += double{kernel[vector[k]]};
    vector += bound_count;
    return free[0] + free[1] + model_.bound[one] * (bound[0] + bound[1]);
  }

  const SvmModel& model_;
  std::span<const double> scaled_;
  KernelValues kernel_;
};

}  // namespace

std::pmr::vector<RankedClass> rank(const SvmModel& model, std::span<const double> scaled,
                                   std::span<const char> allowed, std::size_t max_count,
                                   MemoryResource memory) {
  const std::pmr::vector<std::size_t> classes = classes_of(allowed, memory);
  const PairDecisions machines(model, scaled, classes, memory);
  const auto beats = [&](std::size_t a, std::size_t b) {
    return machines.is_first_preferred(classes[a], classes[b]);
  };
  Tournament tournament(classes.size(), beats, memory);
  std::pmr::vector<RankedClass> ranked(memory);
  ranked.reserve(classes.size());
  while (ranked.size() < std::min(max_count, classes.size())) {
    const auto [player, wins] = tournament.next();
    ranked.push_back({classes[player], static_cast<int>(wins)});
  }
  return ranked;
}

}  // namespace flinch::models
