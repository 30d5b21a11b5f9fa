// SPDX-License-Identifier: MIT
#include "models/tournament.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace flinch::models {
namespace {

using Outcomes = std::vector<std::vector<bool>>;  // [a][b] for a < b: whether a wins

Outcomes random_outcomes(std::mt19937_64& random, std::size_t count, std::uint64_t noise) {
  Outcomes outcomes(count, std::vector<bool>(count));
  std::vector<std::uint64_t> strength(count);
  for (std::uint64_t& each : strength) each = random() % 10;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      outcomes[a][b] = strength[a] + random() % noise >= strength[b] + random() % noise;
    }
  }
  return outcomes;
}

/// Returns the number of wins when all games are played.
std::vector<std::size_t> wins_of(const Outcomes& outcomes) {
  std::vector<std::size_t> wins(outcomes.size());
  for (std::size_t a = 0; a < wins.size(); ++a) {
    for (std::size_t b = a + 1; b < wins.size(); ++b) ++wins[outcomes[a][b] ? a : b];
  }
  return wins;
}

TEST(Tournament, MatchesAFullRoundRobinWithoutRepeatedGames) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 300; ++round) {
    const std::size_t count = 1 + random() % (round % 10 == 0 ? 60 : 12);
    const Outcomes outcomes = random_outcomes(random, count, round % 2 == 0 ? 3 : 100);
    const std::vector<std::size_t> wins = wins_of(outcomes);
    std::vector<std::size_t> expected(count);
    std::iota(expected.begin(), expected.end(), std::size_t{0});
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::size_t a, std::size_t b) { return wins[a] > wins[b]; });
    Outcomes played(count, std::vector<bool>(count));
    Tournament tournament(
        count,
        [&](std::size_t a, std::size_t b) {
          EXPECT_LT(a, b);
          EXPECT_FALSE(played[a][b]);
          played[a][b] = true;
          return bool{outcomes[a][b]};
        },
        std::pmr::get_default_resource());
    for (const std::size_t player : expected) {
      const auto standing = tournament.next();
      ASSERT_EQ(standing.player, player);
      ASSERT_EQ(standing.wins, wins[player]);
    }
  }
}

TEST(Tournament, FindsTheWinnerInAtMost2NMinus3Games) {
  constexpr std::size_t kPlayers = 42;
  for (std::size_t best = 0; best < kPlayers; ++best) {
    std::size_t games = 0;
    Tournament tournament(
        kPlayers,
        [&](std::size_t a, std::size_t b) {
          ++games;
          return a == best || (b != best && a % 3 <= b % 3);
        },
        std::pmr::get_default_resource());
    const auto champion = tournament.next();
    EXPECT_EQ(champion.player, best);
    EXPECT_EQ(champion.wins, kPlayers - 1);
    EXPECT_LE(games, 2 * kPlayers - 3) << "the others' games decide nothing";
  }
}

}  // namespace
}  // namespace flinch::models
