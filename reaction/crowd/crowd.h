// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reaction/reacting_character.h"

namespace flinch::reaction {

/// Who is where in a crowd.
struct CrowdOptions {
  int characters = 20;
  float half_side_m = 3.5F;  ///< of the square, whose centre is the origin
  std::uint64_t seed = 1;    ///< of places and walks
};

/// What has happened so far.
struct CrowdTally {
  std::size_t bumps = 0;         ///< of two characters
  std::size_t walls = 0;         ///< touched by a character
  std::size_t answered = 0;      ///< pushes by either, with a recorded response
  std::size_t physical = 0;      ///< by physics, since no response would look real
  std::size_t knocked_over = 0;  ///< of those
};

/// A push that a character has taken.
struct CrowdPush {
  std::size_t character = 0;
  Eigen::Vector2f at = Eigen::Vector2f::Zero();        ///< where its chest is, on the ground, m
  Eigen::Vector2f velocity = Eigen::Vector2f::Zero();  ///< that the pushed joint shall reach, m/s
  bool is_physical = false;  ///< answered by physics, not by a recorded response
};

/// Characters that walk about in a square, and push each other and are pushed by its walls (Arikan
/// et al. 2005, figure 7). They keep to the square as far as their motion graph has a way.
/// `library` and `graph` must outlive it. The same options and frames give the same motion.
class Crowd {
 public:
  Crowd(const runtime::Library& library, const runtime::MotionGraph& graph,
        const CrowdOptions& options = {});

  void update(float dt_s);

  const std::vector<ReactingCharacter>& characters() const { return characters_; }
  const CrowdOptions& options() const { return options_; }
  const CrowdTally& tally() const { return tally_; }
  /// The pushes of the last frame.
  const std::vector<CrowdPush>& pushes() const { return pushes_; }

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

  const CrowdOptions options_;
  const motion::Skeleton& skeleton_;
  std::vector<ReactingCharacter> characters_;
  std::vector<Body> bodies_;
  std::vector<CrowdPush> pushes_;
  CrowdTally tally_;
};

}  // namespace flinch::reaction
