// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/character.h"

namespace flinch::crowd {

/// Who is where.
struct Options {
  int characters = 20;
  float half_side_m = 3.5F;  ///< of the square, whose centre is the origin
  std::uint64_t seed = 1;    ///< of places and walks
};

/// What has happened so far.
struct Tally {
  std::size_t bumps = 0;     ///< of two characters
  std::size_t walls = 0;     ///< touched by a character
  std::size_t answered = 0;  ///< pushes by either
  std::size_t weaker = 0;    ///< of those: with a weaker push than was asked first
  std::size_t refused = 0;   ///< no response would look real
};

/// Characters that walk about in a square, and push each other and are pushed by its walls (Arikan
/// et al. 2005, figure 7). `library` and `graph` must outlive it. The same options and frames give
/// the same motion.
class Crowd {
 public:
  Crowd(const runtime::Library& library, const runtime::MotionGraph& graph, const Options& options,
        runtime::Workspace& workspace);

  void update(float dt_s);

  const std::vector<runtime::Character>& characters() const { return characters_; }
  const Tally& tally() const { return tally_; }

 private:
  struct Body {
    Eigen::Vector2f chest = Eigen::Vector2f::Zero();  ///< on the ground, m
    Eigen::Vector2f velocity = Eigen::Vector2f::Zero();
    float facing = 0;
    float rest_s = 0;  ///< for which it takes no further push
  };
  void observe(float dt_s);
  void bump(std::size_t one, std::size_t other);
  void touch_walls(std::size_t one);
  void push(std::size_t one, const Eigen::Vector2f& velocity);

  const Options options_;
  const motion::Skeleton& skeleton_;
  runtime::Workspace& workspace_;
  std::vector<runtime::Character> characters_;
  std::vector<Body> bodies_;
  Tally tally_;
};

}  // namespace flinch::crowd
