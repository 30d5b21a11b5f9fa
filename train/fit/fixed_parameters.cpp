// SPDX-License-Identifier: MIT
#include "train/fit/fixed_parameters.h"

#include <algorithm>

namespace flinch::train {
namespace {

template <typename Parameters>
std::vector<Parameters> each_once(const std::vector<Parameters>& grid) {
  std::vector<Parameters> unique;
  for (const Parameters& candidate : grid)
    if (std::ranges::find(unique, candidate) == unique.end()) unique.push_back(candidate);
  return unique;
}

}  // namespace

std::vector<models::KnnParameters> narrow(std::vector<models::KnnParameters> grid,
                                          const FixedParameters& fixed) {
  for (models::KnnParameters& candidate : grid) candidate.k = fixed.k.value_or(candidate.k);
  return each_once(grid);
}

std::vector<models::SvmParameters> narrow(std::vector<models::SvmParameters> grid,
                                          const FixedParameters& fixed, int feature_count) {
  for (models::SvmParameters& candidate : grid) {
    if (fixed.libsvm_defaults) {
      const models::SvmKernel kernel = candidate.kernel;
      candidate = models::default_svm_parameters(feature_count);
      candidate.kernel = kernel;
    }
    candidate.cost = fixed.c.value_or(candidate.cost);
    candidate.gamma = fixed.gamma.value_or(candidate.gamma);
    if (candidate.kernel != models::SvmKernel::polynomial) continue;
    candidate.degree = fixed.degree.value_or(candidate.degree);
    candidate.coef0 = fixed.coef0.value_or(candidate.coef0);
  }
  return each_once(grid);
}

std::vector<models::PairwiseParameters> narrow(std::vector<models::PairwiseParameters> grid,
                                               const FixedParameters& fixed) {
  for (models::PairwiseParameters& candidate : grid) candidate.c = fixed.c.value_or(candidate.c);
  return each_once(grid);
}

}  // namespace flinch::train
