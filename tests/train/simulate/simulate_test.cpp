// SPDX-License-Identifier: MIT
#include "train/simulate/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "database/files/provenance.h"
#include "lookahead/oracle/oracle.h"
#include "motion/error.h"
#include "runtime/response/response.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/guard.h"
#include "tests/train/simulate/local_messenger.h"
#include "tests/train/store/made_up_store.h"
#include "train/store/store_places.h"
#include "train/store/store_trials.h"

namespace flinch::train {
namespace {

TEST(ClipsToTry, AreTheAllowedClipsAndTheIdleClip) {
  database::ClipLibrary library = scenes::synthetic_library();
  library.clips[2].annotation.reset();
  std::vector<std::string> names;
  for (const int clip : lookahead::clips_to_try(library, motion::Target::head))
    names.push_back(library.clip(clip).name);
  EXPECT_EQ(names, (std::vector<std::string>{"idle", "raise_hands", "turn_shoulder",
                                             "duck_mirrored", "turn_shoulder_mirrored"}));
}

TEST(ReferenceWork, IsPositiveForClipsThatMoveAndTheSameForTheirMirrorImages) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  EXPECT_EQ(reference_work_j(setup, library.idle), 0);
  for (std::size_t i = 1; i < library.clips.size(); ++i)
    EXPECT_GT(reference_work_j(setup, static_cast<int>(i)), 1) << library.clips[i].name;
}

TEST(ReferenceWork, ResponsesArePlayedAtTheirOwnRate) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  for (int clip = 1; clip < static_cast<int>(library.clips.size()); ++clip) {
    const auto& annotation = library.clip(clip).annotation;
    EXPECT_EQ(runtime::make_response(prepared, {}, clip, annotation->peak_s + 0.5F).playback_rate,
              1);
  }
}

TEST(StoreHeader, KeepsTheReferencesOfTheNormalisation) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  const StoreHeader header = make_store_header(setup);
  // (1 + 0.7) * 0.27 kg * 30 m/s
  EXPECT_NEAR(header.reference_impulse_ns, 13.77, 1e-12);
  EXPECT_EQ(header.reference_work_j, *std::ranges::max_element(header.clip_work_j));
  EXPECT_EQ(header.clips.size(), library.clips.size());
}

// A store of other laws is then not continued or merged: its `simulation` differs.
TEST(StoreHeader, NamesTheVersionOfTheLaws) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const std::string simulation = make_store_header(SimulationSetup(library, {})).simulation;
  EXPECT_NE(simulation.find("\"law_version\":" + std::to_string(sim::kLawVersion)),
            std::string::npos)
      << simulation;
}

TEST(StoreHeader, RejectsALibraryWithoutAnnotatedClips) {
  database::ClipLibrary library = scenes::synthetic_library();
  for (motion::Clip& clip : library.clips) clip.annotation.reset();
  const SimulationSetup setup(library, {});
  EXPECT_THROW(make_store_header(setup), Error);
}

TEST(Trials, ABallGivesAnIdlingCharacterAPlausibleImpulse) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  int hits = 0;
  for (std::uint64_t number = 0; number < 20; ++number) {
    const Observation posed = make_observation(setup, number);
    const Trial trial = try_clip(setup, posed.scenario, library.idle);
    double impulse = 0;
    for (const float i : trial.impulse) impulse += double{i};
    hits += impulse > 1 ? 1 : 0;
    EXPECT_EQ(trial.work_j, 0);
    // The bound is two hits of the hardest ball, with parts driven into each other.
    EXPECT_LT(impulse, 4 * 13.77);
  }
  EXPECT_GE(hits, 14) << "most aimed balls hit one who stands still";
}

Batch simulated(const SimulationSetup& setup, ScenarioRange range, int threads,
                RehearsalCache& rehearsals) {
  Batch batch;
  BatchContext context;
  context.threads = threads;
  EXPECT_TRUE(simulate_batch(setup, rehearsals, range, context, batch));
  EXPECT_EQ(batch.observations.size(), range.count);
  return batch;
}

std::vector<std::vector<std::byte>> trials_of(const Batch& batch) {
  std::vector<std::vector<std::byte>> bytes;
  for (const Observation& observation : batch.observations) {
    EXPECT_FALSE(observation.trials.empty());
    bytes.push_back(encode_trials(observation.trials));
  }
  return bytes;
}

TEST(SimulateBatch, DoesNotDependOnThreadsMemoryAndBatches) {
  const database::ClipLibrary library = scenes::synthetic_library();
  SimulationPlan plan;
  plan.tail_s = 0.05;
  const SimulationSetup setup(library, plan);
  RehearsalCache all(std::uint64_t{1} << 30);
  RehearsalCache none(0);
  const Batch batch = simulated(setup, {5, 4}, 1, all);
  const auto alone = trials_of(batch);
  EXPECT_TRUE(alone == trials_of(simulated(setup, {5, 4}, 2, all))) << "as kept";
  EXPECT_TRUE(alone == trials_of(simulated(setup, {5, 4}, 3, none))) << "rehearsed anew";
  const auto apart = trials_of(simulated(setup, {7, 1}, 1, none));
  EXPECT_TRUE(alone[2] == apart[0]) << "by itself";
  EXPECT_GT(all.byte_count(), 0U);
  EXPECT_EQ(none.byte_count(), 0U);
  std::uint64_t trials = 0;
  for (const Observation& observation : batch.observations) trials += observation.trials.size();
  EXPECT_EQ(batch.counts.simulations, trials);
  EXPECT_LE(batch.counts.hits + batch.counts.skipped, trials);
  EXPECT_GT(batch.counts.hits, 0U);
}

std::vector<std::vector<std::byte>> places_of(const Batch& batch) {
  std::vector<std::vector<std::byte>> bytes;
  for (const Observation& observation : batch.observations)
    bytes.push_back(encode_places(observation.places));
  return bytes;
}

TEST(SimulateBatch, KeepsThePlacesOfHitsOnRequestAndChangesNoImpulse) {
  const database::ClipLibrary library = scenes::synthetic_library();
  SimulationPlan plan;
  RehearsalCache without(std::uint64_t{1} << 30);
  const Batch plain = simulated(SimulationSetup(library, plan), {0, 12}, 2, without);
  for (const Observation& observation : plain.observations) EXPECT_TRUE(observation.places.empty());
  plan.options.keeps_places = true;
  const SimulationSetup setup(library, plan);
  RehearsalCache rehearsals(std::uint64_t{1} << 30);
  const Batch batch = simulated(setup, {0, 12}, 1, rehearsals);
  EXPECT_TRUE(trials_of(batch) == trials_of(plain));
  EXPECT_TRUE(places_of(batch) == places_of(simulated(setup, {0, 12}, 3, rehearsals)));
  std::size_t places = 0;
  for (const Observation& observation : batch.observations) {
    auto place = observation.places.begin();
    for (const Trial& trial : observation.trials) {
      motion::PerBody<float> sum;
      for (; place != observation.places.end() && place->clip == trial.clip; ++place, ++places) {
        sum[place->body] += place->impulse_ns;
        const motion::Shape& shape = setup.body_model[place->body].shape;
        const float reach_m = shape.radius + shape.half_length + shape.half_extents.norm();
        EXPECT_LT((point_of(*place) - shape.centre).norm(), reach_m + 0.01F);
      }
      for (const motion::Body body : motion::kBodies)
        EXPECT_NEAR(sum[body], trial.impulse[body], 1e-5F + 1e-5F * trial.impulse[body]);
    }
    EXPECT_EQ(place, observation.places.end());
  }
  EXPECT_GT(places, 50U);
}

TEST(RehearsalCache, StaysWithinItsMaximumSize) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  const auto first = std::make_shared<const RehearsedResponse>(rehearse(setup, {0, {0, 0}}));
  const auto second = std::make_shared<const RehearsedResponse>(rehearse(setup, {0, {1, 0}}));
  RehearsalCache rehearsals(first->byte_count() + second->byte_count() - 1);
  rehearsals.insert(first);
  rehearsals.insert(first);
  rehearsals.insert(second);
  EXPECT_EQ(rehearsals.byte_count(), first->byte_count());
  EXPECT_EQ(rehearsals.find(first->key), first);
  EXPECT_EQ(rehearsals.find(second->key), nullptr);
}

TEST(MemoryPlan, RejectsTooLittleMemoryNamingTheMinimum) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  const MemoryPlan plan = plan_memory(setup, std::uint64_t{1} << 30, 2);
  EXPECT_TRUE(plan.keeps_all());
  EXPECT_EQ(plan.response_count, setup.responses.count());
  EXPECT_THAT(tests::error_of([&] { plan_memory(setup, 1 << 20, 2); }),
              testing::HasSubstr("--memory 96M"));
  EXPECT_NO_THROW(plan_memory(setup, 96 << 20, 2));
}

TEST(MemoryPlan, WithoutMemoryForAllResponsesThereAreFewAndLargeBatches) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  const std::uint64_t all_bytes = plan_memory(setup, std::uint64_t{1} << 30, 1).all_response_bytes;
  const std::uint64_t program_bytes = 80 << 20;
  const MemoryPlan enough = plan_memory(setup, program_bytes + all_bytes, 1);
  const MemoryPlan scarce = plan_memory(setup, program_bytes + all_bytes / 2, 1);
  const MemoryPlan none = plan_memory(setup, program_bytes, 1);
  EXPECT_TRUE(enough.keeps_all());
  EXPECT_FALSE(scarce.keeps_all());
  EXPECT_FALSE(none.keeps_all());
  EXPECT_LT(enough.batch_size, none.batch_size);
  EXPECT_LT(none.batch_size, scarce.batch_size);
  EXPECT_EQ(none.response_bytes, 0U);
  EXPECT_LT(scarce.response_bytes, all_bytes / 2);
}

/// The sum of the bodies' differences, divided by the total of both.
double difference(const Trial& a, const Trial& b) {
  double whole = 0;
  double change = 0;
  for (const motion::Body body : motion::kBodies) {
    whole += double{std::max(a.impulse[body], b.impulse[body])};
    change += double{std::abs(a.impulse[body] - b.impulse[body])};
  }
  return whole > 0 ? change / whole : 0;
}

TEST(SharedTrials, MatchFullSimulations) {
  const database::ClipLibrary library = scenes::synthetic_library();
  SimulationPlan plan;
  plan.distribution.kinds[0].time_to_impact_s.min = 0.5;  // so that many responses start later
  const SimulationSetup setup(library, plan);
  sim::ThrowSimulator throws(setup.simulator);
  int compared = 0;
  int close = 0;
  for (std::uint64_t number = 0; number < 12; ++number) {
    const Observation posed = make_observation(setup, number);
    const GridCell cell = grid_cell_of(plan.distribution, setup.stances, posed.scenario);
    for (const int clip : {posed.trials.front().clip, posed.trials.back().clip}) {
      const RehearsedResponse shared = rehearse(setup, setup.responses.key_of(clip, cell));
      const Trial slow = try_clip(setup, posed.scenario, clip);
      const RehearsedTrial rehearsed{posed.scenario, shared};
      const Trial fast = try_rehearsed(setup, {&rehearsed, 1}, throws).front().trial;
      EXPECT_NEAR(slow.work_j, fast.work_j, 1e-3F * slow.work_j);
      close += difference(slow, fast) < 0.005 ? 1 : 0;
      ++compared;
    }
  }
  EXPECT_GE(close, compared - 1);
}

/// A run of the whole range, as the program sets it up.
SimulationRun run_of(const SimulationSetup& setup, ScenarioRange wanted, int threads) {
  SimulationRun run;
  run.wanted = wanted;
  run.batch.threads = threads;
  run.memory = plan_memory(setup, std::uint64_t{1} << 30, threads);
  return run;
}

class SimulateStore : public testing::Test {
 protected:
  static SimulationPlan plan() {
    SimulationPlan plan;
    plan.tail_s = 0.05;
    return plan;
  }

  std::string whole() {
    EXPECT_TRUE(simulate_store(setup_, folder_ / "whole", run_of(setup_, kWanted, 2)));
    return read_file(folder_ / "whole");
  }

  /// Works as process `rank` until process 0 ends the run.
  void help(LocalExchange& exchange, int rank) {
    LocalMessenger messenger(exchange, rank);
    SimulationRun run = run_of(setup_, kWanted, 1);
    run.messenger = &messenger;
    run_simulation_worker(setup_, run);
  }

  static constexpr ScenarioRange kWanted{3, 18};
  TemporaryFolder folder_;
  database::ClipLibrary library_ = scenes::synthetic_library();
  SimulationSetup setup_{library_, plan()};
};

TEST_F(SimulateStore, ResumedRunGivesTheBytesOfAnUninterruptedRun) {
  std::atomic<bool> stop = false;
  SimulationRun run = run_of(setup_, kWanted, 1);
  run.batch.stop = &stop;
  run.report = [&stop](const SimulationProgress& progress) { stop = progress.scenarios >= 16; };
  EXPECT_FALSE(simulate_store(setup_, folder_ / "stopped", run));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "stopped"));
  EXPECT_EQ(summarise_store(folder_ / "stopped.partial").observation_count, 16U);
  stop = false;
  run.report = [](const SimulationProgress&) {};
  ASSERT_TRUE(simulate_store(setup_, folder_ / "stopped", run));
  EXPECT_TRUE(read_file(folder_ / "stopped") == whole());
}

TEST_F(SimulateStore, DoesNotDependOnTheNumberOfProcesses) {
  LocalExchange exchange(3);
  std::vector<std::jthread> workers;
  for (int rank = 1; rank < 3; ++rank) {
    workers.emplace_back([&, rank] { help(exchange, rank); });
  }
  LocalMessenger messenger(exchange, 0);
  SimulationRun run = run_of(setup_, kWanted, 1);
  run.messenger = &messenger;
  SimulationProgress last;
  run.report = [&last](const SimulationProgress& progress) { last = progress; };
  ASSERT_TRUE(simulate_store(setup_, folder_ / "crew", run));
  EXPECT_EQ(last.scenarios, kWanted.count);
  EXPECT_TRUE(read_file(folder_ / "crew") == whole());
}

TEST_F(SimulateStore, TellsStancesApartWhateverTheirNames) {
  const database::ClipLibrary library = tests::with_guard(scenes::synthetic_library());
  const auto options_with = [&](const std::string& name) {
    SimulationPlan plan = SimulateStore::plan();
    plan.distribution.stances = {{0, "idle", 2}, {1, name, 1}};
    const SimulationSetup setup(library, plan);
    EXPECT_TRUE(simulate_store(setup, folder_ / name, run_of(setup, {0, 1}, 1)));
    const StoreReader store(folder_ / name);
    return database::provenance_of(store.header().provenance).value().options;
  };
  using Options = decltype(options_with(""));
  EXPECT_EQ(options_with("walk"), (Options{{"stances", "idle=2 walk=1"}}));
  EXPECT_EQ(options_with("my walk=1 b"), (Options{{"stances", "idle=2 'my walk=1 b'=1"}}));
}

TEST_F(SimulateStore, AFinishedStoreStopsTheWorkers) {
  whole();
  LocalExchange exchange(2);
  std::jthread worker([&] { help(exchange, 1); });
  LocalMessenger messenger(exchange, 0);
  SimulationRun run = run_of(setup_, kWanted, 1);
  run.messenger = &messenger;
  EXPECT_TRUE(simulate_store(setup_, folder_ / "whole", run));
}

}  // namespace
}  // namespace flinch::train
