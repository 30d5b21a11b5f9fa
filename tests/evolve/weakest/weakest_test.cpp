// SPDX-License-Identifier: MIT
#include "evolve/weakest/weakest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "database/author/authored_library.h"
#include "database/files/library_writer.h"
#include "database/quality/quality.h"
#include "motion/default_character.h"

namespace flinch::evolve {
namespace {

/// A library that has no answer to most threats.
const database::ClipLibrary& poor_library() {
  static const database::ClipLibrary poor = [] {
    database::ClipLibrary library = database::authored_library(motion::default_character());
    std::erase_if(library.clips, [](const motion::Clip& clip) {
      return clip.annotation && clip.name != "sidestep_legs_front_exaggerated";
    });
    return library;
  }();
  return poor;
}

WeakestOptions small_run(int threads) {
  WeakestOptions options;
  options.cells = 2;
  options.scenarios = 1024;
  options.genetic.population = 16;
  options.genetic.max_generations = 3;
  options.threads = threads;
  return options;
}

const ReportWeakest kSilent = [](const EvolutionSeries&, std::span<const CellCost>) {};

struct WholeRun {
  database::ClipLibrary library = poor_library();
  EvolutionSeries series;
  MendedLibrary mended;
};
const WholeRun& finished() {
  static const WholeRun run = [] {
    WholeRun made;
    made.mended = mend_weakest(small_run(2), kSilent, made.library, made.series).value();
    return made;
  }();
  return run;
}

TEST(Weakest, LowersTheOraclesCostInTheWeakestCellsOnFreshScenarios) {
  const MendedLibrary& mended = finished().mended;
  ASSERT_EQ(mended.cells.size(), 2U);
  EXPECT_GE(mended.cells[0].weak.mean_ns, mended.cells[1].weak.mean_ns);
  EXPECT_LT(mended.cells_gain.after_ns, 0.95 * mended.cells_gain.before_ns);
  EXPECT_LT(mended.cells_gain.difference_ns.interval.high, 0);
  EXPECT_EQ(mended.whole_gain.scenarios, 1024U);
  EXPECT_LT(mended.whole_gain.after_ns, mended.whole_gain.before_ns);
  EXPECT_GT(mended.whole_gain.after_ns, 0);
}

TEST(Weakest, KeepsClipsThatAreSoundAndTheirMirrorImages) {
  std::size_t kept = 0;
  for (const MendedCell& cell : finished().mended.cells) kept += cell.clip.empty() ? 0 : 1;
  ASSERT_GT(kept, 0U);
  const database::ClipLibrary& library = finished().library;
  ASSERT_EQ(library.clips.size(), poor_library().clips.size() + 2 * kept);
  const auto table = measure_quality(library);
  for (std::size_t k = poor_library().clips.size(); k < library.clips.size(); ++k)
    EXPECT_THAT(broken_bounds(table[k]), testing::IsEmpty()) << library.clips[k].name;
}

TEST(Weakest, GivesTheSameBytesOnOneThreadAndWhenInterruptedAnywhere) {
  database::ClipLibrary library = poor_library();
  EvolutionSeries series;
  for (int reports = 1;; ++reports) {
    // Each run ends after one report more of the whole run's, and the next continues it.
    std::atomic<bool> stop = false;
    WeakestOptions options = small_run(1);
    options.stop = &stop;
    library = poor_library();
    int left = 1;
    const auto report = [&](const EvolutionSeries&, std::span<const CellCost>) {
      if (--left == 0) stop = true;
    };
    if (mend_weakest(options, report, library, series)) break;
    ASSERT_LT(reports, 20);
  }
  EXPECT_EQ(database::library_bytes(library), database::library_bytes(finished().library));
  const auto& expected = finished().series.finished;
  ASSERT_EQ(series.finished.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    ASSERT_EQ(series.finished[k].history.size(), expected[k].history.size());
    for (std::size_t g = 0; g < expected[k].history.size(); ++g)
      EXPECT_EQ(series.finished[k].history[g].mean_fitness, expected[k].history[g].mean_fitness);
  }
}

}  // namespace
}  // namespace flinch::evolve
