// SPDX-License-Identifier: MIT
// Time and memory that pairwise machines take to fit: pairwise_scale 8200 50000 200000.
#include <chrono>
#include <cstdio>

#include "features/feature_vector.h"
#include "models/fit/pairwise_linear_fit.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

void fit(int count) {
  using Clock = std::chrono::steady_clock;
  const TrainingSet set = four_masks(5, count, features::kFeatureCount);
  const double before_s = bench::process_cpu_s();
  const auto begin = Clock::now();
  const PairwiseModel model = fit_pairwise(set, {});
  const std::chrono::duration<double> taken = Clock::now() - begin;
  std::printf("%12d %8.1f %8.1f %10.0f %9zu\n", count, bench::process_cpu_s() - before_s,
              taken.count(), bench::peak_memory_mib(), model.weights.size() / model.row_size());
  std::fflush(stdout);
}

void run(const bench::StudyArguments& arguments) {
  std::printf("observations   CPU, s     s    memory, MiB  machines\n");
  for (std::size_t i = 0; i < arguments.count(); ++i) fit(arguments.number<int>(i));
}

}  // namespace
}  // namespace flinch::models

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"pairwise_scale OBSERVATIONS...", 1, 100},
                                   flinch::models::run);
}
