// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "models/clip_mask.h"

namespace flinch::models {

/// Max-wins voting among `count` players of whom each meets each other once: who wins most games
/// comes first, ties by the lower number. A game is asked for only when the order of those who are
/// asked for depends on it; what comes out is what playing all games would give.
///
/// `beats(a, b)`, for a < b, says whether a wins against b. Called once a pair at the most: after a
/// knock-out, who has lost least so far plays who has lost least of the others, until nobody can
/// get past. 2 count - 3 games at the most tell the champion where one wins all of its own.
template <typename Beats>
class Tournament {
 public:
  struct Standing {
    std::size_t player = 0;
    std::size_t wins = 0;
  };

  /// Takes count ints and count^2 bytes of the memory; count is below 2^14.
  Tournament(std::size_t count, Beats beats, MemoryResource memory)
      : beats_(std::move(beats)), standing_(count, memory), played_(count * count, memory) {
    for (std::size_t player = 0; player < count; ++player) {
      standing_[player] = static_cast<int>(player);
      played_[player * count + player] = 1;
    }
    // A knock-out: afterwards all but one have lost.
    for (std::size_t champion = 0, next = 1; next < count; ++next) {
      if (!wins_against(champion, next)) champion = next;
    }
  }

  /// Who comes after those that it gave before; to be asked count times at the most.
  Standing next() {
    std::size_t best = player_of(first());
    for (int rival = first_not_met_by(best); rival < kOut; rival = first_not_met_by(best)) {
      // Losses only grow, so who does not lose stays first.
      if (!wins_against(best, player_of(rival))) best = player_of(first());
    }
    const int losses = standing_[best] / kLoss;
    standing_[best] += kOut;
    return {best, count() - 1 - static_cast<std::size_t>(losses)};
  }

 private:
  static constexpr int kLoss = 1 << 16;
  static constexpr int kOut = 1 << 29;

  std::size_t count() const { return standing_.size(); }
  static std::size_t player_of(int standing) { return static_cast<std::size_t>(standing % kLoss); }

  int first() const {
    int lowest = standing_.front();
    for (const int each : standing_) lowest = std::min(lowest, each);
    return lowest;
  }

  /// The strongest opponents come first: against them most games are decided that decide anything.
  /// kOut or above where there is none left.
  int first_not_met_by(std::size_t player) const {
    const char* met = &played_[player * count()];
    int lowest = kOut;
    for (std::size_t other = 0; other < count(); ++other) {
      lowest = std::min(lowest, standing_[other] + met[other] * kOut);
    }
    return lowest;
  }

  /// Plays a game that has not been played.
  bool wins_against(std::size_t player, std::size_t other) {
    const bool wins = player < other ? beats_(player, other) : !beats_(other, player);
    standing_[wins ? other : player] += kLoss;
    played_[player * count() + other] = played_[other * count() + player] = 1;
    return wins;
  }

  Beats beats_;
  /// Of each player kLoss for every loss, plus the number, so that the least comes first, ties by
  /// the lower number; plus kOut once it has been given.
  std::pmr::vector<int> standing_;
  std::pmr::vector<char> played_;  ///< count() rows of one a player, who has met itself
};

}  // namespace flinch::models
