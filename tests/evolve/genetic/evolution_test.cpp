// SPDX-License-Identifier: MIT
#include "evolve/genetic/evolution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/error.h"
#include "tests/scenes/error_of.h"

namespace flinch::evolve {
namespace {

GeneticOptions small(std::uint64_t seed) {
  GeneticOptions options;
  options.population = 100;
  options.max_generations = 30;
  options.seed = seed;
  return options;
}

/// Distance from a fixed chromosome: one optimum and no traps.
std::vector<double> distances(std::size_t, std::span<const Chromosome> chromosomes) {
  std::vector<double> fitness;
  for (const Chromosome& chromosome : chromosomes) {
    double sum = 0;
    for (std::size_t i = 0; i < chromosome.size(); ++i)
      sum += std::abs(static_cast<double>(chromosome[i]) - 4000.0 * static_cast<double>(i + 1));
    fitness.push_back(sum);
  }
  return fitness;
}

const CheckFitness kNoCheck = [](const Chromosome&) { return 0.0; };

TEST(Evolution, NeverLosesTheBest) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    GeneticOptions options = small(seed);
    options.mutation = MutationScheme::b;  // children that are far from their parents
    Evolution evolution = begin_evolution(options, 6);
    while (evolution.history.size() < 15) {
      advance(options, distances, kNoCheck, evolution);
      const std::size_t last = evolution.history.size() - 1;
      EXPECT_THAT(evolution.chromosomes, testing::Contains(evolution.history[last].best));
      if (last == 0) continue;
      EXPECT_LE(evolution.history[last].best_fitness, evolution.history[last - 1].best_fitness);
    }
  }
}

TEST(Evolution, KeepsTheBetterHalfOfEveryTournament) {
  for (const std::size_t size : {4U, 8U}) {
    GeneticOptions options = small(3);
    options.tournament = size;
    const Evolution evolution = begin_evolution(options, 6);
    const std::vector<double> fitness = distances(0, evolution.chromosomes);
    const std::vector<Chromosome> next =
        next_generation(options, 1, evolution.chromosomes, fitness);
    ASSERT_EQ(next.size(), options.population);  // 100 leaves a last tournament of 4 beside eights
    std::size_t kept = 0;
    for (const Chromosome& chromosome : evolution.chromosomes)
      kept += static_cast<std::size_t>(std::ranges::count(next, chromosome));
    EXPECT_EQ(kept, options.population / 2);
    // The worst size / 2 of all win no tournament; the best size / 2 win every one.
    std::vector<std::size_t> ranks(fitness.size());
    for (std::size_t i = 0; i < ranks.size(); ++i) ranks[i] = i;
    std::ranges::sort(ranks, {}, [&](std::size_t i) { return fitness[i]; });
    for (std::size_t k = 0; k < size / 2; ++k) {
      EXPECT_THAT(next, testing::Contains(evolution.chromosomes[ranks[k]]));
      EXPECT_THAT(next, testing::Not(testing::Contains(evolution.chromosomes[ranks[99 - k]])));
    }
  }
}

TEST(Evolution, ALeftOverPairFormsATournamentOfItsOwn) {
  GeneticOptions options = small(4);
  options.population = 6;
  Evolution evolution = begin_evolution(options, 6);
  for (int k = 0; k < 5; ++k) {
    advance(options, distances, kNoCheck, evolution);
    EXPECT_EQ(evolution.chromosomes.size(), 6U);
  }
}

TEST(Evolution, GivesTheSameBitsAgainAndWhenItIsContinuedFromACopy) {
  const GeneticOptions options = small(5);
  Evolution whole = begin_evolution(options, 6);
  Evolution copy;
  for (int k = 0; k < 12; ++k) {
    advance(options, distances, kNoCheck, whole);
    if (k == 5) copy = whole;
  }
  for (int k = 6; k < 12; ++k) advance(options, distances, kNoCheck, copy);
  EXPECT_EQ(whole.chromosomes, copy.chromosomes);
  EXPECT_EQ(whole.history.back().best, copy.history.back().best);
  EXPECT_EQ(whole.history.back().mean_fitness, copy.history.back().mean_fitness);
  Evolution other = begin_evolution(small(6), 6);
  EXPECT_NE(other.chromosomes, begin_evolution(options, 6).chromosomes);
}

// A planar arm of two bones that should hold its hand near a point in front of a wall, with little
// bending: the two ways to bend the elbow are two valleys, and the wall cuts one of them off.
double arm_cost(double shoulder, double elbow) {
  const double x = 0.28 * std::cos(shoulder) + 0.27 * std::cos(shoulder + elbow);
  const double y = 0.28 * std::sin(shoulder) + 0.27 * std::sin(shoulder + elbow);
  const double elbow_y = 0.28 * std::sin(shoulder);
  const double through_wall = std::max(0.0, elbow_y - 0.12) + std::max(0.0, y - 0.2);
  const double beside = std::hypot(x - 0.3, y - 0.1);
  return 0.05 + 10 * beside * beside + 0.01 * (shoulder * shoulder + elbow * elbow) +
         2 * through_wall;
}

TEST(Evolution, ComesWithinTwoPercentOfAGridSearchOfTwoDegreesOfFreedomForAllOfTwentySeeds) {
  const GeneRange turn{-std::numbers::pi, std::numbers::pi};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 1000; ++i) {
    for (int k = 0; k <= 1000; ++k) {
      least = std::min(least, arm_cost(turn.min + (turn.max - turn.min) * i / 1000,
                                       turn.min + (turn.max - turn.min) * k / 1000));
    }
  }
  const auto evaluate = [&](std::size_t, std::span<const Chromosome> chromosomes) {
    std::vector<double> fitness;
    for (const Chromosome& chromosome : chromosomes)
      fitness.push_back(arm_cost(value_of(chromosome[0], turn), value_of(chromosome[1], turn)));
    return fitness;
  };
  const auto check = [&](const Chromosome& chromosome) {
    return evaluate(0, {&chromosome, 1}).front();
  };
  int within = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    GeneticOptions options;
    options.ends = GeneEnds::wrap;
    options.seed = seed;
    Evolution evolution = begin_evolution(options, 2);
    while (!has_ended(options, evolution)) advance(options, evaluate, check, evolution);
    within += evolution.history.back().best_fitness <= 1.02 * least ? 1 : 0;
  }
  EXPECT_EQ(within, 20);
}

TEST(Evolution, EndsWhenTheCheckedBestHasNotImprovedForAWindowAndNotBefore) {
  GeneticOptions options;
  options.window = 3;
  options.min_improvement = 0.01;
  const auto has_ended_after = [&](const std::vector<double>& checks) {
    std::vector<GenerationRecord> history;
    // What the generations themselves met says nothing.
    for (const double check : checks)
      history.push_back({static_cast<double>(history.size()), 7, {}, check});
    return has_converged(options, history);
  };
  EXPECT_FALSE(has_ended_after({10, 10, 10}));
  EXPECT_TRUE(has_ended_after({10, 10, 10, 10}));
  EXPECT_TRUE(has_ended_after({20, 10, 10.5, 11, 9.95}));
  EXPECT_FALSE(has_ended_after({20, 10, 10.5, 11, 9.85}));
  EXPECT_FALSE(has_ended_after({10, 9, 12, 12}));
  EXPECT_TRUE(has_ended_after({10, 9, 12, 12, 12}));
  EXPECT_TRUE(has_ended_after({-10, -10.05, -10, -10}));  // blocks far away may score below 0
}

TEST(Evolution, EndsAfterTheMostGenerations) {
  GeneticOptions options = small(1);
  options.max_generations = 4;
  Evolution evolution = begin_evolution(options, 6);
  while (!has_ended(options, evolution)) advance(options, distances, kNoCheck, evolution);
  EXPECT_EQ(evolution.history.size(), 4U);
}

TEST(Evolution, RefusesPopulationsThatTournamentsCannotPair) {
  const auto message = [](std::size_t population, std::size_t tournament) {
    GeneticOptions options;
    options.population = population;
    options.tournament = tournament;
    return tests::error_of([&] { begin_evolution(options, 2); });
  };
  EXPECT_THAT(message(0, 4), testing::HasSubstr("a population of 0; it must be even"));
  EXPECT_THAT(message(401, 4), testing::HasSubstr("a population of 401"));
  EXPECT_THAT(message(4, 8), testing::HasSubstr("at least as large as a tournament, 8"));
  EXPECT_THAT(message(400, 6), testing::HasSubstr("a tournament of 6; it must be a multiple of 4"));
  EXPECT_THAT(message(400, 0), testing::HasSubstr("a tournament of 0"));
}

}  // namespace
}  // namespace flinch::evolve
