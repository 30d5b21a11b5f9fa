// SPDX-License-Identifier: MIT
// A small evolution from a throw to a clip.
#include "evolve/run/pose_evolution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "database/author/authored_library.h"
#include "database/files/library_writer.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "tests/scenes/error_of.h"

namespace flinch::evolve {
namespace {

const database::ClipLibrary& library() {
  static const database::ClipLibrary authored =
      database::authored_library(motion::default_character());
  return authored;
}

PoseTrial trial_of(Style style) {
  TrialOptions options;
  options.style = style;
  options.thrown = throw_at(library().character, library().idle_clip().motion, motion::Target::head,
                            motion::radians(30.0), 0, 25, 0.5);
  return {library().character, library().idle_clip().motion, options};
}

PoseEvolution small_run(int threads) {
  PoseEvolution run;
  run.genetic.population = 40;
  run.genetic.max_generations = 6;
  run.threads = threads;
  return run;
}

const ClipDescription kDescription{"evolved", motion::Target::head, motion::radians(30.0), "test"};

/// A whole small run, which several tests look at.
struct SmallRun {
  PoseTrial trial = trial_of(Style::free);
  Evolution evolution;
  EvolvedPose pose;
};
const SmallRun& finished() {
  static const SmallRun run = [] {
    SmallRun made;
    EXPECT_TRUE(evolve_poses(made.trial, small_run(2), made.evolution));
    made.pose =
        chosen_pose(made.trial, small_run(2), made.evolution, library().idle_clip(), kDescription);
    return made;
  }();
  return run;
}

TEST(PoseEvolution, GivesTheSameBitsOnOneThreadAndWhenInterrupted) {
  Evolution evolution;
  PoseEvolution run = small_run(1);
  std::atomic<bool> stop = false;
  run.stop = &stop;
  run.report = [&](const Evolution& now) { stop = now.history.size() == 3; };
  EXPECT_FALSE(evolve_poses(finished().trial, run, evolution));
  EXPECT_EQ(evolution.history.size(), 3U);
  stop = false;
  run.report = [](const Evolution&) {};
  EXPECT_TRUE(evolve_poses(finished().trial, run, evolution));
  const Evolution& expected = finished().evolution;
  EXPECT_EQ(evolution.chromosomes, expected.chromosomes);
  ASSERT_EQ(evolution.history.size(), expected.history.size());
  for (std::size_t k = 0; k < expected.history.size(); ++k) {
    EXPECT_EQ(evolution.history[k].mean_fitness, expected.history[k].mean_fitness);
    EXPECT_EQ(evolution.history[k].best, expected.history[k].best);
  }
}

TEST(PoseEvolution, MeetsTheBallsOfItsNumberInEachGeneration) {
  const std::vector<GenerationRecord>& history = finished().evolution.history;
  for (std::size_t k = 0; k < history.size(); ++k) {
    const auto score = finished().trial.test({&history[k].best, 1}, k, 1);
    EXPECT_EQ((*score)[0].fitness(), history[k].best_fitness) << "generation " << k;
  }
}

TEST(PoseEvolution, GenesThatStandForAFullTurnHaveNoEnds) {
  TrialOptions turned = trial_of(Style::free).options();
  turned.gene_map = GeneMap::full_turn;
  const PoseTrial trial(library().character, library().idle_clip().motion, turned);
  PoseEvolution run = small_run(2);
  run.genetic.population = 8;
  run.genetic.max_generations = 1;
  Evolution evolution;
  EXPECT_TRUE(evolve_poses(trial, run, evolution));
  const Evolution first = begin_evolution(run.genetic, trial.genes().size());
  const std::vector<PoseScore> scores = trial.test(first.chromosomes, 0, 1).value();
  std::vector<double> fitness;
  for (const PoseScore& score : scores) fitness.push_back(score.fitness());
  const auto next = [&](GeneEnds ends) {
    run.genetic.ends = ends;
    return next_generation(run.genetic, 1, first.chromosomes, fitness);
  };
  EXPECT_EQ(evolution.chromosomes, next(GeneEnds::wrap));
  EXPECT_NE(evolution.chromosomes, next(GeneEnds::reflect));
}

TEST(PoseEvolution, ProtectsFromBallsThatNoGenerationMet) {
  const double pain =
      clip_pain(finished().trial, library().idle_clip(), finished().pose.clip.clip, kUnseenDraw, 4);
  EXPECT_LT(pain, 0.7 * finished().trial.idle_pain());
  EXPECT_GT(pain, 0);
}

TEST(EvolvedClip, KeepsEveryBoundOfQualityAndJoinsALibraryWithItsMirrorImage) {
  const motion::Clip& clip = finished().pose.clip.clip;
  database::ClipLibrary grown = library();
  add_clip(clip, grown);
  ASSERT_EQ(grown.clips.size(), library().clips.size() + 2);
  const auto table = measure_quality(grown);
  for (std::size_t k = library().clips.size(); k < grown.clips.size(); ++k)
    EXPECT_THAT(broken_bounds(table[k]), testing::IsEmpty()) << grown.clips[k].name;
  EXPECT_EQ(grown.clips.back().mirrored_from, clip.name);
  EXPECT_NEAR(grown.clips.back().annotation->direction, -clip.annotation->direction, 1e-6);
  EXPECT_FALSE(database::library_bytes(grown).empty());  // keeps the invariants of a library
  EXPECT_THAT(tests::error_of([&] { add_clip(clip, grown); }),
              testing::HasSubstr("has a clip 'evolved' already"));
}

TEST(EvolvedClip, ReachesThePoseAtItsPeakAndIsAnnotatedToTheNearestEighth) {
  const motion::Clip& clip = finished().pose.clip.clip;
  const motion::Pose goal = finished().trial.pose(finished().pose.chromosome);
  const motion::Pose peak = sample(clip.motion, clip.annotation->peak_s);
  const motion::Skeleton& skeleton = library().character.skeleton;
  const motion::JointFrames expected = forward_kinematics(skeleton, goal);
  const motion::JointFrames found = forward_kinematics(skeleton, peak);
  for (const motion::Role role :
       {motion::Role::left_hand, motion::Role::right_hand, motion::Role::head})
    EXPECT_LT((found.position[role] - expected.position[role]).norm(), 0.03F);
  EXPECT_NEAR(clip.annotation->direction, motion::radians(45.0), 1e-6);
  const auto direction = [&](double degrees) {
    ClipDescription description = kDescription;
    description.azimuth = motion::radians(degrees);
    return motion::degrees(double{make_evolved_clip(finished().trial.figure(),
                                                    library().idle_clip(), {goal, 0.3}, description)
                                      .clip.annotation->direction});
  };
  EXPECT_NEAR(direction(-20), 0, 1e-4);
  EXPECT_NEAR(direction(-180), 180, 1e-4);
  EXPECT_NEAR(direction(-95), -90, 1e-4);
}

}  // namespace
}  // namespace flinch::evolve
