// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "motion/clip.h"
#include "motion/pose_distance.h"

namespace flinch::reaction {

/// Where in a clip a character continues, and how the clip is laid in the world: by
/// motion::placed() with `yaw` and `translation`.
struct ReactionMatch {
  int clip = 0;                                           ///< index in the span that was searched
  float time_s = 0;                                       ///< time in the clip
  float yaw = 0;                                          ///< radians
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< horizontal, m
  float distance_m = 0;                                   ///< D, see ReactionClips
};

/// The pose of a matched clip `time_since_match_s` after the match, world; the clip's last pose
/// after its end. `clip` is the one that the match names, unplaced.
motion::Pose pose_of(const motion::Clip& clip, const ReactionMatch& match,
                     float time_since_match_s) noexcept;

/// By how much a push sets the body of a clip in motion: the highest speed of its centre of mass
/// over 0.1 s toward the point where it is farthest from its place in the first pose, along that
/// direction; horizontal, m/s. Zero for a body that stands still.
Eigen::Vector2f push_of(const motion::Physique& character, const motion::Motion& motion);

/// Finds the clip that best continues a simulated motion, as Zordan et al. 2005 do: the frame whose
/// bodies are nearest, each weighted by its mass, and move most alike: the distance D of
/// motion/pose_distance.h is least.
///
/// A clip must fit the blow, too: a body that was hit from the front does not step forward, as it
/// would after a push from behind. With the blow b and the clip's own push p (push_of()), both seen
/// from the facing, a frame is admitted if
///
///     angle(b, p) <= 60 degrees   and   |b - p| <= 0.75 m/s.
///
/// At 60 degrees half of the push still goes the way of the blow; clips of four directions, 90
/// degrees apart, leave no blow unanswered. And 0.75 m/s is the velocity that alone makes half of
/// the largest distance: 0.1 s 0.75 m/s = 0.075 m. A blow or push of zero has no direction and
/// admits by strength.
class ReactionClips {
 public:
  /// Prepares 30 frames per second of those `clips` that have this purpose, except for the last
  /// 0.3 s of each, after which the clip would end at once. The clips are not needed afterwards.
  /// Allocates; throws std::bad_alloc.
  ReactionClips(const motion::Physique& character, std::span<const motion::Clip> clips,
                motion::Purpose purpose = motion::Purpose::push);

  /// The admitted frame nearest to a character in pose `now` that was in pose `before` `dt_s`
  /// earlier, world. `blow_mps` is the horizontal velocity that the blow gave to the character's
  /// centre of mass, world: the momentum that the ball lost to it, over the character's mass. None
  /// if D exceeds `max_distance_m` everywhere, if no clip fits the blow, if a pose is not sound
  /// (motion::is_sound), if the blow is not finite or if `dt_s` is not positive and finite. Of
  /// equal frames, the first. Costs about 10 ns per frame; allocates nothing.
  std::optional<ReactionMatch> find(
      const motion::Pose& before, const motion::Pose& now, float dt_s,
      const Eigen::Vector2f& blow_mps,
      float max_distance_m = motion::kMaxSeamDistance_m) const noexcept;

  std::size_t size() const { return frames_.size(); }  ///< number of frames that are searched

 private:
  struct Frame {
    motion::PoseFeatures features;
    int clip;
    float time_s;
    float facing;
    Eigen::Vector2f pelvis;                              // on the ground
    Eigen::Vector2f push_mps = Eigen::Vector2f::Zero();  // in the frame of the facing
  };
  Frame frame_of(const motion::Pose& before, const motion::Pose& now, float dt_s) const;

  motion::PoseMetric metric_;
  std::vector<Frame> frames_;
};

}  // namespace flinch::reaction
