// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reaction/reacting_character.h"

namespace flinch::crowd {

/// Who is where.
struct Options {
  int characters = 20;
  float half_side_m = 3.5F;  ///< of the square, whose centre is the origin
  std::uint64_t seed = 1;    ///< of places and walks
};

/// What has happened so far.
struct Tally {
  std::size_t bumps = 0;         ///< of two characters
  std::size_t walls = 0;         ///< touched by a character
  std::size_t answered = 0;      ///< pushes by either, with a recorded response
  std::size_t physical = 0;      ///< by physics, since no response would look real
  std::size_t knocked_over = 0;  ///< of those
};

/// Characters that walk about in a square, and push each other and are pushed by its walls (Arikan
/// et al. 2005, figure 7). They keep to the square as far as their motion graph has a way.
/// `library` and `graph` must outlive it. The same options and frames give the same motion.
class Crowd {
 public:
  Crowd(const runtime::Library& library, const runtime::MotionGraph& graph, const Options& options);

  void update(float dt_s);

  const std::vector<reaction::ReactingCharacter>& characters() const { return characters_; }
  const Tally& tally() const { return tally_; }

 private:
  struct Body {
    Eigen::Vector2f chest = Eigen::Vector2f::Zero();  ///< on the ground, m
    Eigen::Vector2f velocity = Eigen::Vector2f::Zero();
    float facing = 0;
    float rest_s = 0;   ///< for which it takes no further push
    float lying_s = 0;  ///< since it was knocked over
  };
  void observe(float dt_s);
  void bump(std::size_t one, std::size_t other);
  void touch_walls(std::size_t one);
  void push(std::size_t one, const Eigen::Vector2f& velocity);
  void help_up(std::size_t one, float dt_s);

  const Options options_;
  const motion::Skeleton& skeleton_;
  std::vector<reaction::ReactingCharacter> characters_;
  std::vector<Body> bodies_;
  Tally tally_;
};

}  // namespace flinch::crowd
