// SPDX-License-Identifier: MIT
#include "evolve/weakest/cell_trial.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "database/author/authored_library.h"
#include "evolve/weakest/cell_costs.h"
#include "evolve/weakest/clip_genes.h"
#include "motion/default_character.h"

namespace flinch::evolve {
namespace {

/// The authored clips against threats to the head from the front, and those that idle.
database::ClipLibrary small_library() {
  database::ClipLibrary library = database::authored_library(motion::default_character());
  std::erase_if(library.clips, [](const motion::Clip& clip) {
    return clip.annotation &&
           (clip.annotation->target != motion::Target::head || clip.annotation->direction != 0);
  });
  return library;
}

class CellTrialTest : public testing::Test {
 protected:
  database::ClipLibrary library_ = small_library();
  ThreatCell cell_{motion::Target::head, 2, 1};
  train::CostModel cost_model_{.of_kind = {}, .reference_damage_ns = {14}, .reference_work_j = 500};
  train::ScenarioRange range_{100, 10};

  CellTrial trial(int threads) const { return {{library_, {}, cost_model_, threads}, cell_}; }
  static std::vector<Chromosome> chromosomes(std::size_t count) {
    features::Random random(3, features::RandomStream::evolution, 0);
    std::vector<Chromosome> all(count, Chromosome(clip_gene_count()));
    for (Chromosome& chromosome : all)
      for (Gene& gene : chromosome) gene = static_cast<Gene>(random.index(65536));
    return all;
  }
};

// One clip at a time in the library, and one simulation of the reference solver at a time.
TEST_F(CellTrialTest, IsTheCostOfTheOracleWithTheClipInTheLibrary) {
  const std::vector<Chromosome> clips = chromosomes(3);
  CellTrial fast = trial(1);
  const auto scores = fast.test(clips, range_);
  ASSERT_TRUE(scores);
  train::SimulationPlan plan;
  plan.distribution = threats_in(plan.distribution, cell_).value();
  plan.distribution.idle_phase_count = 1;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    database::ClipLibrary grown = library_;
    const motion::Figure figure = motion::make_figure(library_.character);
    const motion::Clip& idle = library_.idle_clip();
    constexpr double kLongest_s = 0.7;  // the cell's longest time to impact
    grown.clips.push_back(clip_to(
        figure, idle, paced_pose_of(figure, idle.motion.poses.front(), clips[i], kLongest_s),
        {"evolved", cell_.target, cell_.azimuth(), ""}));
    const train::SimulationSetup setup(grown, plan);
    double oracle_ns = 0;
    double cost_ns = 0;
    for (std::uint64_t number = range_.first; number < range_.end(); ++number) {
      train::Observation observation = make_observation(setup, number);
      for (train::Trial& tried : observation.trials)
        tried = try_clip(setup, observation.scenario, tried.clip);
      oracle_ns += oracle_cost_ns(observation, cost_model_, std::numeric_limits<int>::max()) / 10;
      cost_ns += cost_of(observation.trials.back(), 0, cost_model_) / 10;
    }
    EXPECT_NEAR((*scores)[i].cost_ns, cost_ns, 0.03 * cost_ns) << i;
    EXPECT_NEAR((*scores)[i].oracle_ns, oracle_ns, 0.03 * oracle_ns) << i;
  }
}

TEST_F(CellTrialTest, GivesTheSameBitsForAnyNumberOfThreadsAndCompany) {
  const std::vector<Chromosome> clips = chromosomes(6);
  CellTrial one = trial(1);
  CellTrial three = trial(3);
  const auto expected = one.test(clips, range_);
  const auto found = three.test(clips, range_);
  ASSERT_TRUE(expected && found);
  EXPECT_EQ(std::memcmp(expected->data(), found->data(), 6 * sizeof(ClipScore)), 0);
  const auto alone = one.test({&clips[4], 1}, range_);
  EXPECT_EQ(std::memcmp(&(*alone)[0], &(*expected)[4], sizeof(ClipScore)), 0);
}

TEST_F(CellTrialTest, StopsWhenTold) {
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(trial(1).test(chromosomes(1), range_, &stop));
}

}  // namespace
}  // namespace flinch::evolve
