// SPDX-License-Identifier: MIT
#include "train/simulate.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "runtime/response.h"
#include "tests/train/made_up_store.h"
#include "train/store_trials.h"

namespace flinch::train {
namespace {

constexpr auto kNoReport = [](const SimulationProgress&) {};

TEST(ClipsToTry, AreTheAllowedOnesAndIdle) {
  database::Library library = scenes::synthetic_library();
  library.clips[2].annotation.reset();
  std::vector<std::string> names;
  for (const int clip : clips_to_try(library, motion::Target::head))
    names.push_back(library.clips[static_cast<std::size_t>(clip)].name);
  EXPECT_EQ(names, (std::vector<std::string>{"idle", "raise_hands", "turn_shoulder",
                                             "duck_mirrored", "turn_shoulder_mirrored"}));
}

TEST(ReferenceWork, IsPositiveForClipsThatMoveAndTheSameForTheirMirrorImages) {
  const database::Library library = scenes::synthetic_library();
  const SimulationSubject subject(library, {});
  EXPECT_EQ(reference_work_j(subject, library.idle), 0);
  for (std::size_t i = 1; i < library.clips.size(); ++i)
    EXPECT_GT(reference_work_j(subject, static_cast<int>(i)), 1) << library.clips[i].name;
}

TEST(ReferenceWork, ResponsesArePlayedAtTheirOwnRate) {
  const database::Library library = scenes::synthetic_library();
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  for (int clip = 1; clip < static_cast<int>(library.clips.size()); ++clip) {
    const auto& annotation = library.clips[static_cast<std::size_t>(clip)].annotation;
    EXPECT_EQ(runtime::make_response(prepared, {}, clip, annotation->peak_s + 0.5F).playback_rate,
              1);
  }
}

TEST(StoreHeader, KeepsTheReferencesOfTheNormalisation) {
  const database::Library library = scenes::synthetic_library();
  const SimulationSubject subject(library, {});
  const StoreHeader header = make_store_header(subject);
  // (1 + 0.7) * 0.27 kg * 30 m/s
  EXPECT_NEAR(header.reference_impulse_ns, 13.77, 1e-12);
  EXPECT_EQ(header.reference_work_j, *std::ranges::max_element(header.clip_work_j));
  EXPECT_EQ(header.clips.size(), library.clips.size());
}

TEST(StoreHeader, ALibraryWithoutAnnotatedClipsIsRefused) {
  database::Library library = scenes::synthetic_library();
  for (motion::Clip& clip : library.clips) clip.annotation.reset();
  const SimulationSubject subject(library, {});
  EXPECT_THROW(make_store_header(subject), Error);
}

TEST(Trials, ABallAtAnIdlerLeavesAPlausibleImpulse) {
  const database::Library library = scenes::synthetic_library();
  const SimulationSubject subject(library, {});
  int hits = 0;
  for (std::uint64_t number = 0; number < 20; ++number) {
    const Observation posed = pose_scenario(subject, number);
    const Trial trial = try_clip(subject, posed.scenario, library.idle);
    double impulse = 0;
    for (const float i : trial.impulse) impulse += double{i};
    hits += impulse > 1 ? 1 : 0;
    EXPECT_EQ(trial.work_j, 0);
    // Two hits of the hardest ball, with parts driven into each other, bound it.
    EXPECT_LT(impulse, 4 * 13.77);
  }
  EXPECT_GE(hits, 14) << "most aimed balls hit one who stands still";
}

std::vector<std::vector<std::byte>> simulated(const SimulationSubject& subject, int threads) {
  std::vector<Observation> observations(3);
  const std::atomic<bool> stop = false;
  EXPECT_TRUE(simulate_batch(subject, threads, 5, observations, stop));
  std::vector<std::vector<std::byte>> bytes;
  for (const Observation& observation : observations) {
    EXPECT_FALSE(observation.trials.empty());
    bytes.push_back(encode_trials(observation.trials));
  }
  return bytes;
}

TEST(SimulateBatch, GivesTheSameBitsForAnyNumberOfThreads) {
  const database::Library library = scenes::synthetic_library();
  const SimulationSubject subject(library, {});
  const auto alone = simulated(subject, 1);
  EXPECT_TRUE(alone == simulated(subject, 2));
  EXPECT_TRUE(alone == simulated(subject, 3));
}

TEST(SimulateStore, StoppedAndRunAgainGivesTheBytesOfAnUninterruptedRun) {
  const TemporaryFolder folder;
  const database::Library library = scenes::synthetic_library();
  SimulationPlan plan;
  plan.tail_s = 0.05;
  const SimulationSubject subject(library, plan);
  std::atomic<bool> stop = false;
  ASSERT_TRUE(simulate_store(subject, folder / "whole", 18, 2, stop, kNoReport));
  const auto stop_after_a_batch = [&stop](const SimulationProgress& progress) {
    stop = progress.scenarios >= 16;
  };
  EXPECT_FALSE(simulate_store(subject, folder / "stopped", 18, 1, stop, stop_after_a_batch));
  EXPECT_FALSE(std::filesystem::exists(folder / "stopped"));
  EXPECT_EQ(summarise_store(folder / "stopped.partial").observation_count, 16U);
  stop = false;
  ASSERT_TRUE(simulate_store(subject, folder / "stopped", 18, 2, stop, kNoReport));
  EXPECT_TRUE(bytes_of(folder / "stopped") == bytes_of(folder / "whole"));
}

}  // namespace
}  // namespace flinch::train
