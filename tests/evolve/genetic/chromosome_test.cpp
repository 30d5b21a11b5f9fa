// SPDX-License-Identifier: MIT
#include "evolve/genetic/chromosome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tests/scenes/sample_count.h"

namespace flinch::evolve {
namespace {

features::Random random_of(std::uint64_t substream) {
  return {7, features::RandomStream::evolution, substream};
}

TEST(Gene, StandsForTheAngleOfEquation45) {
  const GeneRange turn{-std::numbers::pi, std::numbers::pi};
  EXPECT_DOUBLE_EQ(value_of(0, turn), -std::numbers::pi);
  EXPECT_DOUBLE_EQ(value_of(kMaxGene, turn), std::numbers::pi);
  EXPECT_NEAR(value_of(32768, turn), 0, 2 * std::numbers::pi / 65535);
  EXPECT_NEAR(value_of(200, turn) - value_of(0, turn), 1.0986 * std::numbers::pi / 180, 1e-5);
}

TEST(GeneMap, OfLimitsSpansThemAndOfAFullTurnIsEquation45HeldAtThem) {
  const GeneRange elbow{0, 2.4};
  EXPECT_DOUBLE_EQ(angle_of(0, elbow, GeneMap::limits), 0);
  EXPECT_DOUBLE_EQ(angle_of(kMaxGene, elbow, GeneMap::limits), 2.4);
  EXPECT_NEAR(angle_of(kMaxGene / 2, elbow, GeneMap::limits), 1.2, 1e-4);
  // 2 pi i / i_max - pi: a quarter of the turn is pi / 2, half of the genes stand for angles below
  // 0, and a ninth of them for angles above the limit.
  EXPECT_NEAR(angle_of(49151, elbow, GeneMap::full_turn), std::numbers::pi / 2, 1e-4);
  EXPECT_EQ(angle_of(kMaxGene / 2, elbow, GeneMap::full_turn), 0);
  EXPECT_EQ(angle_of(0, elbow, GeneMap::full_turn), 0);
  EXPECT_EQ(angle_of(kMaxGene, elbow, GeneMap::full_turn), 2.4);
  int below = 0;
  int above = 0;
  for (int gene = 0; gene <= kMaxGene; ++gene) {
    const double angle = angle_of(static_cast<Gene>(gene), elbow, GeneMap::full_turn);
    below += angle == elbow.min ? 1 : 0;
    above += angle == elbow.max ? 1 : 0;
  }
  EXPECT_EQ(below, 32768);
  EXPECT_NEAR(above / 65536.0, (std::numbers::pi - 2.4) / (2 * std::numbers::pi), 1e-4);
}

TEST(GeneMap, OfAFullTurnHasNoEndsWhileLimitsDo) {
  EXPECT_EQ(ends_of(GeneMap::full_turn), GeneEnds::wrap);
  EXPECT_EQ(ends_of(GeneMap::limits), GeneEnds::reflect);
}

TEST(Crossover, TakesWholeGenesOfBothParentsAndNoOthers) {
  const Chromosome head{1, 2, 3, 4, 5};
  const Chromosome tail{11, 12, 13, 14, 15};
  EXPECT_EQ(crossed(head, tail, 2), (Chromosome{1, 2, 13, 14, 15}));
  EXPECT_EQ(crossed(tail, head, 4), (Chromosome{11, 12, 13, 14, 5}));
}

TEST(Mutation, SchemesAreThoseOfFigure51) {
  const auto listed = [](MutationScheme scheme) {
    std::vector<std::pair<std::size_t, std::uint32_t>> all;
    for (const Mutation& m : mutations_of(scheme)) all.emplace_back(m.genes, m.distance);
    return all;
  };
  using List = std::vector<std::pair<std::size_t, std::uint32_t>>;
  EXPECT_EQ(listed(MutationScheme::a), (List{{10, 200}, {2, 1000}, {1, 65535}}));
  EXPECT_EQ(listed(MutationScheme::b), (List{{10, 65535}}));
  EXPECT_EQ(listed(MutationScheme::c), (List{{5, 1000}, {5, 65535}}));
  EXPECT_EQ(listed(MutationScheme::d), (List{{20, 200}, {2, 1000}, {1, 65535}}));
}

// A gene is missed by all n draws among G with probability (1 - 1/G)^n, and a draw leaves it as it
// is with probability 1/d. So G (1 - (1 - (1 - 1/d) / G)^n) genes change, and by less than n d.
TEST(Mutation, ChangesAsManyGenesAsItsClosedFormByLessThanItsDistance) {
  constexpr std::size_t kGenes = 18;
  const Mutation mutation{10, 50};
  const int runs = tests::samples(20000);
  double changed = 0;
  features::Random random = random_of(1);
  for (int run = 0; run < runs; ++run) {
    Chromosome chromosome(kGenes, 30000);
    mutate(chromosome, {1, mutation.distance}, GeneEnds::reflect, random);
    EXPECT_GE(std::ranges::count(chromosome, 30000), 17);
    EXPECT_LT(std::abs(*std::ranges::max_element(chromosome) - 30000), 50);
    EXPECT_LT(std::abs(*std::ranges::min_element(chromosome) - 30000), 50);
    chromosome.assign(kGenes, 30000);
    mutate(chromosome, mutation, GeneEnds::reflect, random);
    changed +=
        static_cast<double>(kGenes) - static_cast<double>(std::ranges::count(chromosome, 30000));
  }
  // Two draws of one gene cancel with a probability of about 1/(2 d), which this leaves out.
  const double once = (1 - 1.0 / 50) / kGenes;
  const double expected = kGenes * (1 - std::pow(1 - once, 10));
  EXPECT_NEAR(changed / runs, expected, 6 * 1.5 / std::sqrt(runs) + 0.03);
}

// The change of a gene is a sum of n draws, each with probability 1/G and then +-u with u uniform
// in 0 to d - 1: its mean is 0 and its variance n/G (d - 1)(2 d - 1)/6.
TEST(Mutation, ChangesAGeneByItsClosedFormOnAverage) {
  constexpr std::size_t kGenes = 18;
  const int runs = tests::samples(20000);
  features::Random random = random_of(2);
  double sum = 0;
  double squares = 0;
  for (int run = 0; run < runs; ++run) {
    Chromosome chromosome(kGenes, 30000);
    mutate(chromosome, {10, 200}, GeneEnds::reflect, random);
    for (const Gene gene : chromosome) {
      const double change = static_cast<double>(gene) - 30000;
      sum += change;
      squares += change * change;
    }
  }
  const double draws = static_cast<double>(runs) * kGenes;
  const double variance = 10.0 / kGenes * 199 * 399 / 6;
  EXPECT_NEAR(sum / draws, 0, 5 * std::sqrt(variance / draws));
  // The fourth moment is n/G (d - 1)^4 / 5 and three times as much for pairs of draws.
  const double fourth = 10.0 / kGenes * std::pow(199, 4) / 5 + 3 * variance * variance;
  EXPECT_NEAR(squares / draws, variance, 5 * std::sqrt(fourth / draws));
}

// The statistic of a chi-squared test with 63 degrees of freedom; 5 standard deviations are 119.
double unevenness(const std::vector<int>& counts) {
  double total = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(Mutation, LeavesUniformGenesUniformAtBothKindsOfEnds) {
  const int runs = tests::samples(40000);
  for (const GeneEnds ends : {GeneEnds::reflect, GeneEnds::wrap}) {
    for (const std::uint32_t distance : {1000U, 30000U, std::uint32_t{kMaxGene}}) {
      features::Random random = random_of(distance);
      std::vector<int> counts(64);
      for (int run = 0; run < runs; ++run) {
        Chromosome chromosome{static_cast<Gene>(random.index(65536))};
        for (int k = 0; k < 4; ++k) mutate(chromosome, {1, distance}, ends, random);
        ++counts[chromosome[0] / 1024];
      }
      EXPECT_LT(unevenness(counts), 63 + 5 * std::sqrt(2 * 63.0))
          << "distance " << distance << ", ends " << static_cast<int>(ends);
    }
  }
}

TEST(Mutation, ReflectedGenesStayNearTheirEndAndWrappedGenesReachTheOther) {
  features::Random random = random_of(3);
  bool wrapped = false;
  for (int run = 0; run < 100; ++run) {
    Chromosome near_end{5};
    mutate(near_end, {1, 200}, GeneEnds::reflect, random);
    EXPECT_LT(near_end[0], 205);
    near_end = {5};
    mutate(near_end, {1, 200}, GeneEnds::wrap, random);
    EXPECT_TRUE(near_end[0] < 205 || near_end[0] > 65535 - 195) << near_end[0];
    wrapped |= near_end[0] > 60000;
  }
  EXPECT_TRUE(wrapped);
}

}  // namespace
}  // namespace flinch::evolve
