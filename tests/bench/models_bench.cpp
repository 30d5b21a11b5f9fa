// SPDX-License-Identifier: MIT
// Fitting and selecting with 8200 made-up observations of 120 classes. For a counter named
// times_faster, both were timed alternately in the same run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <flann/flann.hpp>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "models/fit/cross_validation.h"
#include "models/fit/network_fit.h"
#include "models/fit/pairwise_linear_fit.h"
#include "models/selector.h"
#include "tests/bench/measures.h"
#include "tests/models/fit/libsvm_oracle.h"
#include "tests/models/training_sets.h"
#include "train/fit/selector_writer.h"

namespace flinch::models {
namespace {

// As many classes as a default library, and as many observations as its training set.
constexpr int kClasses = 120;
constexpr int kObservations = 8200;

const TrainingSet& training_set() {
  static const TrainingSet kSet =
      random_clouds(1, kObservations, kClasses, features::kFeatureCount);
  return kSet;
}

/// Clips of which a threat at the head allows 42 of 120 classes (7 in 20 protect head or trunk, the
/// others the legs), chosen from by `model`.
template <typename Model>
Selector selector_with(Model model) {
  Selector selector;
  for (int clip = 0; clip < 2 * kClasses; ++clip) {
    const int c = clip / 2;
    const motion::Target upper = c % 2 == 0 ? motion::Target::head : motion::Target::trunk;
    const motion::Target target = c % 20 < 7 ? upper : motion::Target::legs;
    selector.clips.push_back(
        {"clip", motion::Annotation{.target = target, .peak_s = 0.2F, .end_s = 0.5F}});
  }
  selector.layout = features::feature_set_named("paper")->layout;
  selector.scaling.min.assign(features::kFeatureCount, -1);
  selector.scaling.max.assign(features::kFeatureCount, 1);
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

using bench::quantile;
using Choose = std::function<int(const features::FeatureVector&)>;

template <typename Call>
double microseconds_of(const Call& call, clockid_t clock) {
  const double begin_s = bench::clock_s(clock);
  call();
  return 1e6 * (bench::clock_s(clock) - begin_s);
}

/// Measures this thread's CPU time, which other programs do not affect, less the microsecond that
/// reading that clock takes.
template <typename Call>
double processor_us_of(const Call& call) {
  static const double kReading_us = [] {
    std::vector<double> readings(1001);
    for (double& reading : readings) reading = microseconds_of([] {}, CLOCK_THREAD_CPUTIME_ID);
    return quantile(readings, 0.5);
  }();
  return microseconds_of(call, CLOCK_THREAD_CPUTIME_ID) - kReading_us;
}

double sum_of_choices(std::span<const features::FeatureVector> queries, const Choose& choose) {
  double sum = 0;
  for (const features::FeatureVector& query : queries) sum += choose(query);
  return sum;
}

/// Times every call separately and reports the median, the 99th percentile and, as a checksum, the
/// sum of what the calls returned over one round of the queries.
void time_each_call(benchmark::State& state, const Choose& choose) {
  const std::vector<features::FeatureVector> queries = make_queries();
  std::vector<double> microseconds;
  std::size_t next = 0;
  for (auto _ : state) {
    microseconds.push_back(
        processor_us_of([&] { benchmark::DoNotOptimize(choose(queries[next])); }));
    next = (next + 1) % queries.size();
  }
  state.counters["median_us"] = quantile(microseconds, 0.5);
  state.counters["p99_us"] = quantile(microseconds, 0.99);
  state.counters["checksum"] = sum_of_choices(queries, choose);
}

/// The same with one round of the queries per iteration, alternating with `theirs`, which gets an
/// eighth of them. Reports how many times as fast ours is, by the medians. After each change the
/// caches hold the other's data: `cold_us` is our first call after it.
void time_against(benchmark::State& state, const Choose& ours, const Choose& theirs) {
  const std::vector<features::FeatureVector> queries = make_queries();
  std::vector<double> our_us;
  std::vector<double> cold_us;
  std::vector<double> their_us;
  std::size_t first = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const features::FeatureVector& query = queries[(first + i) % queries.size()];
      const double took_us = processor_us_of([&] { benchmark::DoNotOptimize(ours(query)); });
      (i == 0 ? cold_us : our_us).push_back(took_us);
    }
    for (std::size_t i = first % 8; i < queries.size(); i += 8) {
      their_us.push_back(processor_us_of([&] { benchmark::DoNotOptimize(theirs(queries[i])); }));
    }
    ++first;
  }
  state.counters["median_us"] = quantile(our_us, 0.5);
  state.counters["p99_us"] = quantile(our_us, 0.99);
  state.counters["cold_us"] = quantile(cold_us, 0.5);
  state.counters["theirs_us"] = quantile(their_us, 0.5);
  state.counters["times_faster"] = quantile(their_us, 0.5) / quantile(our_us, 0.5);
  state.counters["checksum"] = sum_of_choices(queries, ours);
  state.counters["theirs_checksum"] = sum_of_choices(queries, theirs);
}

std::vector<double> to_doubles(const features::FeatureVector& x) {
  return {x.begin(), x.begin() + features::kFeatureCount};
}

const std::array<SvmParameters, 2> kSvms{
    SvmParameters{.degree = 3, .gamma = 1.0 / features::kFeatureCount, .coef0 = 1, .cost = 10},
    SvmParameters{.gamma = 1.0 / features::kFeatureCount, .cost = 10, .kernel = SvmKernel::rbf}};

const SvmModel& svm_model(benchmark::State& state) {
  static const std::array<SvmModel, 2> kModels{fit_svm(training_set(), kSvms[0]),
                                               fit_svm(training_set(), kSvms[1])};
  return kModels[static_cast<std::size_t>(state.range(0))];
}

// The benchmarks' argument is the kernel: 0 polynomial, 1 RBF.

const LibsvmOracle& libsvm(benchmark::State& state) {
  static const std::array<LibsvmOracle, 2> kOracles{LibsvmOracle(training_set(), kSvms[0]),
                                                    LibsvmOracle(training_set(), kSvms[1])};
  return kOracles[static_cast<std::size_t>(state.range(0))];
}

int libsvm_choice(benchmark::State& state, const features::FeatureVector& x) {
  return libsvm(state).predict(to_doubles(x));
}

/// A selector's choice among 42 of 120 clips, against svm_predict's among all, which has no mask.
void select_by_svm(benchmark::State& state) {
  const Selector selector = selector_with(svm_model(state));
  libsvm(state);  // is trained before timing starts
  time_against(
      state,
      [&](const features::FeatureVector& x) { return select(selector, x, motion::Target::head); },
      [&](const features::FeatureVector& x) { return libsvm_choice(state, x); });
  state.counters["file_mib"] =
      static_cast<double>(train::selector_bytes(selector).size()) / (1 << 20);
}
BENCHMARK(select_by_svm)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// The same with all votes counted.
void rank_by_svm(benchmark::State& state) {
  const Selector selector = selector_with(svm_model(state));
  time_each_call(state, [&](const features::FeatureVector& x) {
    return candidates(selector, x, motion::Target::head).front().clip;
  });
}
BENCHMARK(rank_by_svm)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

/// The choice among all 120, against svm_predict's. Both choose the same: the checksums agree.
void svm_without_mask(benchmark::State& state) {
  const SvmModel& model = svm_model(state);
  time_against(
      state,
      [&](const features::FeatureVector& x) {
        return model.label[static_cast<std::size_t>(predict(model, to_doubles(x)))];
      },
      [&](const features::FeatureVector& x) { return libsvm_choice(state, x); });
}
BENCHMARK(svm_without_mask)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void select_by_knn(benchmark::State& state) {
  const Selector selector = selector_with(fit_knn(training_set(), {10, KnnVote::majority}));
  time_each_call(state, [&](const features::FeatureVector& x) {
    return select(selector, x, motion::Target::trunk);
  });
}
BENCHMARK(select_by_knn)->Unit(benchmark::kMicrosecond);

/// As large as a study: 8200 scenarios of 120 clips, with the cost of each clip.
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

/// The nearest ten of large_set() without a mask, against FLANN's exact tree as in its manual. The
/// checksums add up the neighbours' indices, and agree.
void find_neighbours(benchmark::State& state) {
  const KnnModel model = fit_knn(large_set(), {10, KnnVote::majority});
  std::vector<double> points = large_set().points;
  const flann::Matrix<double> rows(points.data(), 8200, features::kFeatureCount);
  flann::KDTreeSingleIndex<flann::L2<double>> tree(rows, flann::KDTreeSingleIndexParams());
  tree.buildIndex();
  std::array<int, 10> found{};
  std::array<double, 10> distance{};
  flann::Matrix<int> indices(found.data(), 1, found.size());
  flann::Matrix<double> distances(distance.data(), 1, distance.size());
  time_against(
      state,
      [&](const features::FeatureVector& x) {
        return nearest(model, to_doubles(x), 10, {}).front().observation;
      },
      [&](const features::FeatureVector& x) {
        std::vector<double> query = to_doubles(x);
        tree.knnSearch(flann::Matrix<double>(query.data(), 1, query.size()), indices, distances,
                       found.size(), flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
        return found.front();
      });
}
BENCHMARK(find_neighbours)->Unit(benchmark::kMillisecond);

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

// The same fits by the kernels of one instruction set: 0 the baseline, 1 AVX2, 2 AVX-512.

const Kernels* kernels_of(benchmark::State& state) {
  const Kernels* kernels = kernels_for(static_cast<InstructionSet>(state.range(0)));
  if (kernels) {
    state.SetLabel(kernels->instruction_set);
  } else {
    state.SkipWithError("this processor lacks the instruction set");
  }
  return kernels;
}

void fit_network_by_kernels(benchmark::State& state) {
  const Kernels* kernels = kernels_of(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        fit_network(large_set(), {.member_count = 1, .epoch_count = 1}, *kernels));
  }
}
BENCHMARK(fit_network_by_kernels)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

void fit_pairwise_by_kernels(benchmark::State& state) {
  const Kernels* kernels = kernels_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(fit_pairwise(masked_set(), {}, *kernels));
}
BENCHMARK(fit_pairwise_by_kernels)
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Fits pair by pair on all processors, against svm_train, which uses one.
void fit_one_svm(benchmark::State& state) {
  const SvmParameters& parameters = kSvms[static_cast<std::size_t>(state.range(0))];
  std::vector<double> our_us;
  std::vector<double> their_us;
  for (auto _ : state) {
    our_us.push_back(microseconds_of(
        [&] { benchmark::DoNotOptimize(fit_svm(training_set(), parameters)); }, CLOCK_MONOTONIC));
    their_us.push_back(microseconds_of(
        [&] { benchmark::DoNotOptimize(LibsvmOracle(training_set(), parameters).model().l); },
        CLOCK_MONOTONIC));
  }
  state.counters["ours_ms"] = quantile(our_us, 0.5) / 1e3;
  state.counters["theirs_ms"] = quantile(their_us, 0.5) / 1e3;
  state.counters["times_faster"] = quantile(their_us, 0.5) / quantile(our_us, 0.5);
  state.counters["support_vectors"] = svm_model(state).vector_count();
}
BENCHMARK(fit_one_svm)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->Iterations(5)->UseRealTime();

template <typename Parameters>
void choose_from(benchmark::State& state, const std::vector<Parameters>& grid) {
  const TrainingSet& set = training_set();
  const std::vector<int> fold = assign_folds(set.label, 5, 1);
  const LossFunction mistake = [&set](int observation, int chosen) {
    return chosen == set.label[static_cast<std::size_t>(observation)] ? 0.0 : 1.0;
  };
  double score = 0;
  for (auto _ : state) {
    score = choose_parameters(set, std::span<const Parameters>(grid), fold, mistake).mean_score;
  }
  state.counters["mean_score"] = score;
}

void choose_svm_parameters(benchmark::State& state) {
  const auto kernel = static_cast<SvmKernel>(state.range(0));
  choose_from(state, svm_grid(features::kFeatureCount, kernel));
}
BENCHMARK(choose_svm_parameters)->Arg(0)->Arg(1)->Unit(benchmark::kSecond)->UseRealTime();

void choose_knn_parameters(benchmark::State& state) {
  choose_from(state, knn_grid());
}
BENCHMARK(choose_knn_parameters)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace flinch::models
