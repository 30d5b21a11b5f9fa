// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "models/clip_mask.h"

namespace flinch::models {

/// Max-wins voting among `count` players of whom each meets each other once: who wins most games
/// comes first, ties by the lower number. A game is asked for only when the order of those who are
/// asked for depends on it; what comes out is what playing all games would give.
///
/// `beats(a, b)`, for a < b, says whether a wins against b. Called once a pair at the most, at
/// first only for the champion of a knock-out: 2 count - 3 games where that one wins all of its
/// own.
template <typename Beats>
class Tournament {
 public:
  struct Standing {
    std::size_t player = 0;
    std::size_t wins = 0;
  };

  /// Takes count ints and count^2 bytes of the memory.
  Tournament(std::size_t count, Beats beats, Memory memory)
      : beats_(std::move(beats)), losses_(count, memory), played_(count * count, memory) {
    play_knock_out();
  }

  /// Who comes after those that it gave before; to be asked count times at the most.
  Standing next() {
    for (;;) {
      const auto [best, runner_up] = leaders();
      if (play_rest_of(best, runner_up)) {
        const Standing standing{best, count() - 1 - static_cast<std::size_t>(losses_[best])};
        losses_[best] += kTaken;
        return standing;
      }
    }
  }

 private:
  static constexpr int kTaken = 1 << 20;  // more than there can be losses

  std::size_t count() const { return losses_.size(); }

  /// Afterwards all but one have lost before any has been looked at twice.
  void play_knock_out() {
    std::size_t champion = 0;
    for (std::size_t next = 1; next < count(); ++next) {
      play(champion, next);
      if (losses_[champion] > 0) champion = next;
    }
  }

  /// Fewest losses so far, then the lower number. Losses only grow, so nobody gets before a player
  /// who has played all games and still is the best.
  bool is_before(std::size_t a, std::size_t b) const {
    return b == count() || losses_[a] < losses_[b] || (losses_[a] == losses_[b] && a < b);
  }

  /// The best two so far; count() where there is none.
  std::array<std::size_t, 2> leaders() const {
    std::array<std::size_t, 2> best{count(), count()};
    for (std::size_t player = 0; player < count(); ++player) {
      if (is_before(player, best[0])) {
        best = {player, best[0]};
      } else if (is_before(player, best[1])) {
        best[1] = player;
      }
    }
    return best;
  }

  /// Plays what a player has not played yet, until it falls behind where `rival` stands now (who
  /// may fall behind others meanwhile); whether it never does.
  bool play_rest_of(std::size_t player, std::size_t rival) {
    const int limit = rival == count() ? kTaken : losses_[rival];
    for (std::size_t other = 0; other < count(); ++other) {
      if (other == player || played_[player * count() + other]) continue;
      play(std::min(player, other), std::max(player, other));
      if (losses_[player] > limit || (losses_[player] == limit && rival < player)) return false;
    }
    return true;
  }

  /// a before b.
  void play(std::size_t a, std::size_t b) {
    ++losses_[beats_(a, b) ? b : a];
    played_[a * count() + b] = played_[b * count() + a] = 1;
  }

  Beats beats_;
  std::pmr::vector<int> losses_;   ///< by player
  std::pmr::vector<char> played_;  ///< count() rows of one a player
};

}  // namespace flinch::models
