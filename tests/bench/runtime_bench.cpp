// SPDX-License-Identifier: MIT
// Loading a selector with its clips, as large as the default library's with 2000 scenarios, and
// selecting with it.
#include <benchmark/benchmark.h>

#include <array>

#include "database/files/file_io.h"
#include "runtime/library.h"
#include "runtime/response/prepared_library.h"
#include "runtime/selection.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::runtime {
namespace {

using database::LoadStatus;

constexpr int kClips = 131;
constexpr std::size_t kPosesPerClip = 87;
constexpr int kScenarios = 2000;

const std::string& selector_file() {
  static const std::string kFile =
      tests::made_up_selector(tests::made_up_library(kClips, kPosesPerClip), kScenarios,
                              tests::ModelKind::svm)
          .file();
  return kFile;
}

std::span<const std::byte> selector_bytes() {
  return std::as_bytes(std::span(selector_file()));
}

void set_size(benchmark::State& state) {
  const std::size_t size = selector_file().size();
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(size));
  state.counters["megabytes"] = static_cast<double>(size) / 1e6;
}

/// From a file, verified and prepared: everything that a game waits for.
void load_selector(benchmark::State& state) {
  const tests::TemporaryFolder folder;
  const std::string path = folder / "made_up.flinch";
  database::write_file_atomically(path, selector_file());
  for (auto _ : state) {
    Library library;
    if (library.load(path) != LoadStatus::ok) state.SkipWithError("the selector was refused");
  }
  set_size(state);
}
BENCHMARK(load_selector)->Unit(benchmark::kMillisecond);

void hash_of_selector_file(benchmark::State& state) {
  std::uint64_t hash = 0;
  for (auto _ : state) benchmark::DoNotOptimize(hash ^= database::content_hash(selector_bytes()));
  set_size(state);
}
BENCHMARK(hash_of_selector_file)->Unit(benchmark::kMillisecond);

void prepare_library(benchmark::State& state) {
  Library library;
  if (library.load(selector_bytes()) != LoadStatus::ok) state.SkipWithError("was refused");
  for (auto _ : state) benchmark::DoNotOptimize(prepare(library.clip_library()));
}
BENCHMARK(prepare_library)->Unit(benchmark::kMillisecond);

void select_in_workspace(benchmark::State& state) {
  Library library;
  Workspace workspace;
  if (library.load(selector_bytes()) != LoadStatus::ok ||
      workspace.reserve_memory(library.selection_bytes()) != LoadStatus::ok) {
    state.SkipWithError("was refused");
  }
  std::array<models::Candidate, 8> best;
  features::FeatureVector x{};
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        select(workspace, library.selector(), x, motion::Target::trunk, best).clip);
    x[0] = x[0] < 1 ? x[0] + 0.01F : -1;
  }
  state.counters["kilobytes"] = static_cast<double>(library.selection_bytes()) / 1e3;
}
BENCHMARK(select_in_workspace)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flinch::runtime
