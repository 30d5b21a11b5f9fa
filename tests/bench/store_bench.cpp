// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>

#include "tests/train/store/made_up_store.h"
#include "train/fit/labels.h"
#include "train/store/merge.h"

namespace flinch::train {
namespace {

constexpr int kClips = 131;             // the default library's
constexpr int kTrialsPerScenario = 79;  // tried in its average scenario
constexpr std::uint64_t kAppended = 1000;
constexpr std::int64_t kMany = 100'000;
constexpr std::int64_t kMillion = 1'000'000;

StoreHeader header_of_many_clips() {
  StoreHeader header = made_up_header();
  header.keeps_places = false;  // as by default
  database::ClipLibrary library = scenes::synthetic_library();
  while (header.clips.size() < kClips) {
    library.clips.push_back(library.clips.back());
    library.clips.back().name += "_";
    header.clips.push_back({library.clips.back().name, library.clips.back().annotation});
    header.clip_work_j.push_back(250);
  }
  const std::string file = database::library_bytes(library);
  const auto bytes = std::as_bytes(std::span(file));
  header.library_file.assign(bytes.begin(), bytes.end());
  header.library_hash = database::verify_file(database::kLibraryFormat, bytes).hash;
  return header;
}

/// As sparse as in the default library: of 100 trials 19 leave no impulse, 65 on one body, 11 on
/// two, 4 on three and 1 on four.
int hit_count(features::Random& random) {
  const std::uint64_t share = random.index(100);
  return share < 19 ? 0 : share < 84 ? 1 : share < 95 ? 2 : share < 99 ? 3 : 4;
}

Observation random_observation(const StoreHeader& header, std::uint64_t number) {
  features::Random random(header.seed, features::RandomStream::baseline, number);
  Observation observation = made_up_observation(header, number);
  observation.trials.assign(kTrialsPerScenario, {});
  observation.places.clear();
  for (int i = 0; i < kTrialsPerScenario; ++i) {
    Trial& trial = observation.trials[static_cast<std::size_t>(i)];
    trial.clip = i * (kClips - 1) / (kTrialsPerScenario - 1);
    trial.work_j = trial.clip == header.idle ? 0 : static_cast<float>(random.uniform(20, 900));
    for (int hit = hit_count(random); hit > 0; --hit)
      trial.impulse[motion::kBodies[random.index(motion::kBodyCount)]] =
          static_cast<float>(random.uniform(0.1, 12));
  }
  return observation;
}

/// A number of different observations, which are reused under other numbers.
std::vector<Observation> random_observations(const StoreHeader& header) {
  std::vector<Observation> observations;
  for (std::uint64_t number = 0; number < kAppended; ++number)
    observations.push_back(random_observation(header, number));
  return observations;
}

/// Makes a store of `scenarios` scenarios and returns its size without the library.
double make_store(const std::string& path, const StoreHeader& header,
                  std::vector<Observation>& observations, ScenarioRange range) {
  StoreWriter writer(path, header, range);
  while (!writer.missing().empty()) {
    std::uint64_t number = writer.missing().front().first;
    for (Observation& observation : observations) observation.number = number++;
    writer.append(observations);
  }
  writer.finish();
  return static_cast<double>(std::filesystem::file_size(path) - header.library_file.size());
}

/// A store that is read repeatedly.
struct Made {
  explicit Made(std::uint64_t scenarios)
      : size(make_store(path, header, observations, {0, scenarios})) {}

  TemporaryFolder folder;
  std::string path = folder / "made";
  StoreHeader header = header_of_many_clips();
  std::vector<Observation> observations = random_observations(header);
  double size;
};
const Made& made(std::int64_t scenarios) {
  static const Made kOfMany(kMany);
  static const Made kOfAMillion(kMillion);
  return scenarios == kMany ? kOfMany : kOfAMillion;
}

void count(benchmark::State& state, std::uint64_t scenarios, double size) {
  const auto iterations = static_cast<double>(state.iterations());
  state.SetItemsProcessed(static_cast<std::int64_t>(iterations * static_cast<double>(scenarios)));
  state.SetBytesProcessed(static_cast<std::int64_t>(iterations * size));
  state.counters["bytes_a_scenario"] = size / static_cast<double>(scenarios);
}

/// 1000 scenarios per commit, and the finished file.
void write_store(benchmark::State& state) {
  const StoreHeader header = header_of_many_clips();
  std::vector<Observation> observations = random_observations(header);
  const TemporaryFolder folder;
  const auto scenarios = static_cast<std::uint64_t>(state.range(0));
  double size = 0;
  for (auto _ : state) {
    size = make_store(folder / "a", header, observations, {0, scenarios});
    std::filesystem::remove(folder / "a");
  }
  count(state, scenarios, size);
}
BENCHMARK(write_store)
    ->ArgName("scenarios")
    ->Arg(kMany)
    ->Arg(kMillion)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void read_stored(benchmark::State& state) {
  const Made& store = made(state.range(0));
  for (auto _ : state) {
    StoreReader reader(store.path);
    Observation observation;
    double work_j = 0;
    while (reader.next(observation)) work_j += double{observation.trials.back().work_j};
    benchmark::DoNotOptimize(work_j);
  }
  count(state, static_cast<std::uint64_t>(state.range(0)), store.size);
}
BENCHMARK(read_stored)
    ->Name("read_store")
    ->ArgName("scenarios")
    ->Arg(kMany)
    ->Arg(kMillion)
    ->Unit(benchmark::kMillisecond);

/// From the file to new labels, for another brawn and vulnerability.
void relabel_store(benchmark::State& state) {
  const Made& store = made(state.range(0));
  const CostModel model = make_cost_model(store.header, vulnerability_profiles()[1], 0.3);
  double clips = 0;
  for (auto _ : state) {
    StoreReader reader(store.path);
    Observation observation;
    clips = 0;
    while (reader.next(observation)) {
      const std::size_t best =
          best_trial(observation.trials, costs_of(observation.trials, 0, model));
      clips += observation.trials[best].clip;
    }
  }
  const auto scenarios = static_cast<std::uint64_t>(state.range(0));
  count(state, scenarios, store.size);
  state.counters["mean_label"] = clips / static_cast<double>(scenarios);
}
BENCHMARK(relabel_store)
    ->ArgName("scenarios")
    ->Arg(kMany)
    ->Arg(kMillion)
    ->Unit(benchmark::kMillisecond);

void merge_two_halves(benchmark::State& state) {
  const StoreHeader header = header_of_many_clips();
  std::vector<Observation> observations = random_observations(header);
  const TemporaryFolder folder;
  constexpr std::uint64_t kHalf = 10'000;
  const std::vector<std::string> halves{folder / "a", folder / "b"};
  double size = make_store(halves[0], header, observations, {0, kHalf});
  size += make_store(halves[1], header, observations, {kHalf, kHalf});
  for (auto _ : state) {
    merge_stores(halves, folder / "whole");
    std::filesystem::remove(folder / "whole");
  }
  count(state, 2 * kHalf, size);
}
BENCHMARK(merge_two_halves)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flinch::train
