// SPDX-License-Identifier: MIT
// Fitting and selecting, on 2000 made-up observations of 60 classes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <flann/flann.hpp>
#include <functional>
#include <random>
#include <vector>

#include "models/cross_validation.h"
#include "models/network_fit.h"
#include "models/pairwise_linear_fit.h"
#include "models/selector.h"
#include "tests/models/libsvm_oracle.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

constexpr int kClasses = 60;

const TrainingSet& training_set() {
  static const TrainingSet kSet = random_clouds(1, 2000, kClasses, features::kFeatureCount);
  return kSet;
}

/// Clips that protect the four targets in turn, chosen from by `model`.
template <typename Model>
Selector selector_with(Model model) {
  Selector selector;
  for (int clip = 0; clip < 2 * kClasses; ++clip) {
    const auto target = static_cast<motion::Target>(clip / 2 % motion::kTargetCount);
    selector.clips.push_back({"clip", motion::Annotation{.target = target}});
  }
  selector.layout = features::feature_set_named("paper")->layout;
  selector.scaling.least.assign(features::kFeatureCount, -1);
  selector.scaling.most.assign(features::kFeatureCount, 1);
  selector.model = std::move(model);
  return selector;
}

std::vector<features::FeatureVector> make_queries() {
  std::mt19937_64 random(2);
  std::vector<features::FeatureVector> queries(512);
  for (features::FeatureVector& query : queries) {
    const std::vector<double> point = random_point(random, features::kFeatureCount);
    std::transform(point.begin(), point.end(), query.begin(),
                   [](double value) { return static_cast<float>(value); });
  }
  return queries;
}

/// Times every call by itself and tells the median and the 99th percentile, and a sum of what the
/// calls returned over one round of the queries.
void time_each_call(benchmark::State& state,
                    const std::function<int(const features::FeatureVector&)>& choose) {
  using Clock = std::chrono::steady_clock;
  const std::vector<features::FeatureVector> queries = make_queries();
  std::vector<double> microseconds;
  std::size_t next = 0;
  for (auto _ : state) {
    const auto begin = Clock::now();
    benchmark::DoNotOptimize(choose(queries[next]));
    const std::chrono::duration<double, std::micro> taken = Clock::now() - begin;
    microseconds.push_back(taken.count());
    next = (next + 1) % queries.size();
  }
  std::sort(microseconds.begin(), microseconds.end());
  double checksum = 0;
  for (const features::FeatureVector& query : queries) checksum += choose(query);
  state.counters["median_us"] = microseconds[microseconds.size() / 2];
  state.counters["p99_us"] = microseconds[microseconds.size() * 99 / 100];
  state.counters["checksum"] = checksum;
}

std::vector<double> to_doubles(const features::FeatureVector& x) {
  return {x.begin(), x.end()};
}

const SvmModel& svm_model() {
  static const SvmModel kModel =
      fit_svm(training_set(), default_svm_parameters(features::kFeatureCount));
  return kModel;
}

void select_by_svm(benchmark::State& state) {
  const Selector selector = selector_with(svm_model());
  time_each_call(state, [&](const features::FeatureVector& x) {
    return select(selector, x, motion::Target::trunk);
  });
}
BENCHMARK(select_by_svm)->Unit(benchmark::kMicrosecond);

void svm_without_mask(benchmark::State& state) {
  time_each_call(state, [](const features::FeatureVector& x) {
    const SvmModel& model = svm_model();
    return model.label[static_cast<std::size_t>(predict(model, to_doubles(x)))];
  });
}
BENCHMARK(svm_without_mask)->Unit(benchmark::kMicrosecond);

/// The same model, points and labels as svm_without_mask: the checksums agree.
void libsvm_predict(benchmark::State& state) {
  const LibsvmOracle oracle(training_set(), default_svm_parameters(features::kFeatureCount));
  time_each_call(state,
                 [&](const features::FeatureVector& x) { return oracle.predict(to_doubles(x)); });
}
BENCHMARK(libsvm_predict)->Unit(benchmark::kMicrosecond);

void select_by_knn(benchmark::State& state) {
  const Selector selector = selector_with(fit_knn(training_set(), {10, KnnVote::majority}));
  time_each_call(state, [&](const features::FeatureVector& x) {
    return select(selector, x, motion::Target::trunk);
  });
}
BENCHMARK(select_by_knn)->Unit(benchmark::kMicrosecond);

/// As large as a study: 8200 scenarios of 120 clips, and what each clip costs.
const TrainingSet& large_set() {
  static const TrainingSet kSet =
      with_costs(random_clouds(3, 8200, kClasses, features::kFeatureCount), 4);
  return kSet;
}

void select_by_knn_cost(benchmark::State& state) {
  const Selector selector = selector_with(fit_knn(large_set(), {10, KnnVote::cost}));
  time_each_call(state, [&](const features::FeatureVector& x) {
    return select(selector, x, motion::Target::trunk);
  });
}
BENCHMARK(select_by_knn_cost)->Unit(benchmark::kMicrosecond);

void select_by_network(benchmark::State& state) {
  const Selector selector = selector_with(fit_network(large_set(), {.epoch_count = 1}));
  time_each_call(state, [&](const features::FeatureVector& x) {
    return select(selector, x, motion::Target::trunk);
  });
}
BENCHMARK(select_by_network)->Unit(benchmark::kMicrosecond);

const TrainingSet& masked_set() {
  static const TrainingSet kSet = four_masks(5, 8200, features::kFeatureCount);
  return kSet;
}

/// Chooses among the 42 clips that mask 1 of masked_set() allows.
void select_by_pairwise_machines(benchmark::State& state) {
  Selector selector = selector_with(fit_pairwise(masked_set(), {}));
  for (std::size_t clip = 0; clip < selector.clips.size(); ++clip) {
    selector.clips[clip].annotation->target =
        masked_set().masks[1][clip] ? motion::Target::trunk : motion::Target::legs;
  }
  selector.idle = 30;
  time_each_call(state, [&](const features::FeatureVector& x) {
    return select(selector, x, motion::Target::trunk);
  });
}
BENCHMARK(select_by_pairwise_machines)->Unit(benchmark::kMicrosecond);

/// The nearest ten of large_set(), without a mask; the checksum adds up who is nearest.
void find_neighbours(benchmark::State& state) {
  const KnnModel model = fit_knn(large_set(), {10, KnnVote::majority});
  time_each_call(state, [&](const features::FeatureVector& x) {
    return nearest(model, to_doubles(x), 10, {}).front().observation;
  });
}
BENCHMARK(find_neighbours)->Unit(benchmark::kMicrosecond);

/// The same by FLANN's exact tree, as its manual has it: the checksums agree.
void find_neighbours_by_flann(benchmark::State& state) {
  std::vector<double> points = large_set().points;
  const flann::Matrix<double> rows(points.data(), 8200, features::kFeatureCount);
  flann::KDTreeSingleIndex<flann::L2<double>> tree(rows, flann::KDTreeSingleIndexParams());
  tree.buildIndex();
  std::array<int, 10> found{};
  std::array<double, 10> distance{};
  flann::Matrix<int> indices(found.data(), 1, found.size());
  flann::Matrix<double> distances(distance.data(), 1, distance.size());
  time_each_call(state, [&](const features::FeatureVector& x) {
    std::vector<double> query = to_doubles(x);
    tree.knnSearch(flann::Matrix<double>(query.data(), 1, query.size()), indices, distances,
                   found.size(), flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
    return found.front();
  });
}
BENCHMARK(find_neighbours_by_flann)->Unit(benchmark::kMicrosecond);

void fit_one_network_for_an_epoch(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit_network(large_set(), {.member_count = 1, .epoch_count = 1}));
  }
}
BENCHMARK(fit_one_network_for_an_epoch)->Unit(benchmark::kMillisecond);

void fit_pairwise_machines(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit_pairwise(masked_set(), {}));
  }
}
BENCHMARK(fit_pairwise_machines)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void fit_one_svm(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        fit_svm(training_set(), default_svm_parameters(features::kFeatureCount)));
  }
  state.counters["support_vectors"] = svm_model().vector_count();
}
BENCHMARK(fit_one_svm)->Unit(benchmark::kMillisecond);

template <typename Parameters>
void choose_from(benchmark::State& state, const std::vector<Parameters>& grid) {
  const TrainingSet& set = training_set();
  const std::vector<int> fold = make_folds(set.label, 5, 1);
  const Score mistake = [&set](int observation, int chosen) {
    return chosen == set.label[static_cast<std::size_t>(observation)] ? 0.0 : 1.0;
  };
  double score = 0;
  for (auto _ : state) {
    score = choose_parameters(set, std::span<const Parameters>(grid), fold, mistake).mean_score;
  }
  state.counters["mean_score"] = score;
}

void choose_svm_parameters(benchmark::State& state) {
  choose_from(state, svm_grid(features::kFeatureCount));
}
BENCHMARK(choose_svm_parameters)->Unit(benchmark::kMillisecond)->UseRealTime();

void choose_knn_parameters(benchmark::State& state) {
  choose_from(state, knn_grid());
}
BENCHMARK(choose_knn_parameters)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace flinch::models
