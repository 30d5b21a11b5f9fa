// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::reaction {

/// Where a clip takes a character up, and how the clip is laid there: see motion::placed.
struct ReactionMatch {
  int clip = 0;                                           ///< index in the span that was searched
  float time_s = 0;                                       ///< into the clip
  float yaw = 0;                                          ///< radians
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< level, m
  float distance_m = 0;                                   ///< see ReactionClips
};

/// The pose of a matched clip `time_since_match_s` after the match; its last one when it is over.
motion::Pose pose_of(const motion::Clip& clip, const ReactionMatch& match,
                     float time_since_match_s) noexcept;

/// Finds the clip that goes on from a simulated pose, as Zordan et al. 2005 do: the frame whose
/// bodies are nearest, each weighted by its mass, and move most alike. In the frame of the facing,
/// with its origin on the ground below the pelvis, and with the mass m_b, the position x_b and the
/// velocity v_b of each body's centre,
///
///     D^2 = sum over b of m_b / M (|x_b - x'_b|^2 + T^2 |v_b - v'_b|^2),   T = 0.1 s.
///
/// Velocities stand for the paper's window of frames.
class ReactionClips {
 public:
  /// Looks at 30 frames a second of the clips of `purpose`, but for the last 0.3 s of each, which
  /// would be over at once. Allocates, throws std::bad_alloc; the clips need not be kept.
  ReactionClips(const motion::Physique& character, std::span<const motion::Clip> clips,
                motion::Purpose purpose = motion::Purpose::push);

  /// The nearest frame to the character at `now`, `dt_s` after `before`; none if D exceeds
  /// `max_distance_m` everywhere (then return to idle), if there are no clips, or for poses that
  /// are not sound and times that are not finite and above 0. Ties go to the earlier frame. Costs
  /// about 10 ns a frame; allocates nothing.
  std::optional<ReactionMatch> find(const motion::Pose& before, const motion::Pose& now, float dt_s,
                                    float max_distance_m = kMaxMatchDistance_m) const noexcept;

  /// Within which a clip is near enough, m. Blended over half a second, a body that is 0.15 m off
  /// moves by 0.3 m/s more than it would: less than what bodies differ by in one's own motion.
  static constexpr float kMaxMatchDistance_m = 0.15F;

  std::size_t size() const { return frames_.size(); }  ///< frames that are looked at

 private:
  // Weighted position and velocity a column, heaviest bodies first.
  using Features = Eigen::Matrix<float, 6, motion::kBodyCount>;
  struct Frame {
    Features features;
    int clip;
    float time_s;
    float facing;
    Eigen::Vector2f pelvis;  // on the ground
  };
  Frame frame_of(const motion::Pose& before, const motion::Pose& now, float dt_s) const;

  motion::Skeleton skeleton_;
  motion::BodyModel model_;
  std::array<motion::Body, motion::kBodyCount> order_;
  motion::PerBody<float> weight_;  // sqrt(m_b / M)
  std::vector<Frame> frames_;
};

}  // namespace flinch::reaction
