// SPDX-License-Identifier: MIT
// How long pairwise machines take to fit, and what memory: pairwise_scale 8200 50000 200000.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#include "features/feature_vector.h"
#include "models/fit/pairwise_linear_fit.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Most memory that the process has had so far.
double peak_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
  }
  return 0;
}

void fit(int count) {
  using Clock = std::chrono::steady_clock;
  const TrainingSet set = four_masks(5, count, features::kFeatureCount);
  const double before_s = cpu_s();
  const auto begin = Clock::now();
  const PairwiseModel model = fit_pairwise(set, {});
  const std::chrono::duration<double> taken = Clock::now() - begin;
  std::printf("%12d %8.1f %8.1f %10.0f %9zu\n", count, cpu_s() - before_s, taken.count(),
              peak_mib(), model.weights.size() / model.row_size());
  std::fflush(stdout);
}

}  // namespace
}  // namespace flinch::models

int main(int argc, char** argv) {
  std::printf("observations   CPU, s     s    memory, MiB  machines\n");
  for (int i = 1; i < argc; ++i) flinch::models::fit(std::atoi(argv[i]));
}
