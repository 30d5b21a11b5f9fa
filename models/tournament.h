// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "models/clip_mask.h"

namespace flinch::models {

/// Max-wins voting among `count` players, each of which meets every other once. Players are ranked
/// by wins, ties by the lower number. A game is played only when the order of the requested players
/// depends on it; the ranking equals that after all games.
///
/// `beats(a, b)`, for a < b, returns whether a wins against b. It is called at most once per pair.
/// After a knock-out round, the player with the fewest losses plays the other with the fewest
/// losses until no rival can overtake the leader. Where one player wins all of its games, at most 2
/// count - 3 games determine it.
template <typename Beats>
class Tournament {
 public:
  struct Standing {
    std::size_t player = 0;
    std::size_t wins = 0;
  };

  /// Allocates count ints and count^2 bytes from the resource; count is below 2^14.
  Tournament(std::size_t count, Beats beats, MemoryResource memory)
      : beats_(std::move(beats)), standing_(count, memory), played_(count * count, memory) {
    for (std::size_t player = 0; player < count; ++player) {
      standing_[player] = static_cast<int>(player);
      played_[player * count + player] = 1;
    }
    // A knock-out round: afterwards all players but one have lost at least once.
    for (std::size_t champion = 0, next = 1; next < count; ++next) {
      if (!wins_against(champion, next)) champion = next;
    }
  }

  /// Returns the next player in the ranking. Call it at most count times.
  Standing next() {
    std::size_t best = player_of(first());
    for (int rival = first_not_met_by(best); rival < kOut; rival = first_not_met_by(best)) {
      best = play_from(best, rival);
    }
    const int losses = losses_of(standing_[best]);
    standing_[best] += kOut;
    return {best, count() - 1 - static_cast<std::size_t>(losses)};
  }

 private:
  static constexpr int kLoss = 1 << 16;
  static constexpr int kOut = 1 << 29;

  std::size_t count() const { return standing_.size(); }
  static std::size_t player_of(int standing) { return static_cast<std::size_t>(standing % kLoss); }
  static int losses_of(int standing) { return standing / kLoss; }

  int first() const {
    int lowest = standing_.front();
    for (const int each : standing_) lowest = std::min(lowest, each);
    return lowest;
  }

  /// The strongest opponents come first, because games against them decide the most. Returns kOut
  /// or more where no opponent is left.
  int first_not_met_by(std::size_t player) const {
    const char* met = &played_[player * count()];
    int lowest = kOut;
    for (std::size_t other = 0; other < count(); ++other) {
      lowest = std::min(lowest, standing_[other] + met[other] * kOut);
    }
    return lowest;
  }

  /// Plays the leader against `rival` and, by ascending number, against every other unmet player
  /// with as many losses, until the leader is overtaken. Returns the leader after that.
  std::size_t play_from(std::size_t leader, int rival) {
    for (std::size_t other = player_of(rival); other < count(); ++other) {
      if (losses_of(standing_[other]) != losses_of(rival) || played_[leader * count() + other]) {
        continue;
      }
      // Losses only grow, so a leader that does not lose stays first.
      if (wins_against(leader, other)) continue;
      if (const std::size_t best = player_of(first()); best != leader) return best;
    }
    return leader;
  }

  /// Plays a game that has not been played yet.
  bool wins_against(std::size_t player, std::size_t other) {
    const bool wins = player < other ? beats_(player, other) : !beats_(other, player);
    standing_[wins ? other : player] += kLoss;
    played_[player * count() + other] = played_[other * count() + player] = 1;
    return wins;
  }

  Beats beats_;
  /// Sort key of each player: kLoss per loss, plus the player's number, so that the minimum is the
  /// leader, ties by the lower number; plus kOut once next() has returned the player.
  std::pmr::vector<int> standing_;
  /// count() rows, one per player; a player counts as having met itself
  std::pmr::vector<char> played_;
};

}  // namespace flinch::models
