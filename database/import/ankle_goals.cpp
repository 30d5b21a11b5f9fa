// SPDX-License-Identifier: MIT
#include "database/import/ankle_goals.h"

#include <algorithm>
#include <cmath>

#include "motion/foot.h"
#include "motion/interpolation.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"

namespace flinch::database {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector2f;
using Eigen::Vector3f;

float squared(float value) {
  return value * value;
}

// Computes the horizontal offset c between the skeleton's ankle and the source's. Let A be the
// source's ankle, F the vector from its ankle to its ball, and f that of the skeleton. The points
// at the fraction w of both feet are A + w F and A + c + w f; they differ by c - w g with g = F -
// f. They move equally from one frame to the next when dc = w dg. The foot rotates about the
// fraction w at which it moves least: 0 where the ankle rests, 1 where the ball does.
class AnkleTracker {
 public:
  explicit AnkleTracker(float interval_s) : interval_s_(interval_s) {}

  Vector2f follow(const Vector3f& ankle, const Vector3f& ball, const Vector2f& to_ball,
                  float lift) {
    const Vector2f at_ankle = ankle.head<2>();
    const Vector2f at_ball = ball.head<2>();
    const Vector2f gap = at_ball - at_ankle - to_ball;
    const Vector2f middle = 0.5F * gap;
    if (is_first_) {
      offset_ = middle;
    } else {
      const float ankle_way = (at_ankle - ankle_).squaredNorm();
      const float ball_way = (at_ball - ball_).squaredNorm();
      const float all = ankle_way + ball_way;
      if (all > 0) offset_ += ankle_way / all * (gap - gap_);
      const float slowest = std::sqrt(std::min(ankle_way, ball_way)) / interval_s_;
      offset_ += return_share(slowest, lift) * (middle - offset_);
    }
    is_first_ = false;
    ankle_ = at_ankle;
    ball_ = at_ball;
    gap_ = gap;
    return offset_;
  }

 private:
  // Fraction of the offset that is removed in one frame: 0 while the foot is planted.
  float return_share(float speed_mps, float lift_m) const {
    constexpr float kTime = 0.1F;  // s, time constant of the exponential decay
    const float is_fast = motion::ease_in_ease_out((speed_mps - 0.2F) / 0.6F);
    const float is_up = motion::ease_in_ease_out((lift_m - 0.03F) / 0.05F);
    return std::max(is_fast, is_up) * (1 - std::exp(-interval_s_ / kTime));
  }

  float interval_s_;
  bool is_first_ = true;
  Vector2f ankle_ = Vector2f::Zero();  // of the previous frame, like the next two
  Vector2f ball_ = Vector2f::Zero();
  Vector2f gap_ = Vector2f::Zero();
  Vector2f offset_ = Vector2f::Zero();
};

// One foot of the skeleton in its rest pose.
struct Foot {
  motion::FootRoles roles;
  Vector3f to_ball;
  float ankle_height;
  float ball_height;
  motion::SoleOutline sole;
};

Foot foot_of(const motion::Skeleton& skeleton, motion::Side side) {
  const motion::JointFrames rest = forward_kinematics(skeleton, motion::rest_pose(skeleton));
  const motion::FootRoles roles = motion::roles_of(side);
  return {roles, skeleton.offset[roles.toes], rest.position[roles.foot].z(),
          rest.position[roles.toes].z(), motion::sole_outline(skeleton, side)};
}

// Returns the least height of the ankle at which no point of the foot is below the ground, nor of
// the toes, whether they are in line with the foot or bent so that they are level.
float lowest_ankle(const Foot& foot, const Vector3f& to_ball, const Quaternionf& orientation) {
  const Vector3f along = orientation * Vector3f::UnitX();
  const Vector3f up = orientation * Vector3f::UnitZ();
  // X turned about Y by the angle a is cos(a) X - sin(a) Z.
  const float angle = std::atan2(along.z(), up.z());
  const Quaternionf level = orientation * motion::rotation_about(Vector3f::UnitY(), angle);
  const float toes = std::max(motion::min_height(foot.sole.toes, orientation),
                              motion::min_height(foot.sole.toes, level));
  return std::max(-motion::min_height(foot.sole.foot, orientation), -to_ball.z() - toes);
}

// The ankle's height according to the source's ankle and to its ball, weighted towards whichever is
// nearer to its planted height.
float ankle_height(const Foot& foot, const Vector3f& to_ball, float ankle_lift, float ball_lift) {
  constexpr float kEven = 0.005F;  // m: lifts well below this weigh the same
  const float by_ankle = foot.ankle_height + ankle_lift;
  const float by_ball = foot.ball_height + ball_lift - to_ball.z();
  const float ankle_weight = squared(std::max(ball_lift, 0.0F) + kEven);
  const float ball_weight = squared(std::max(ankle_lift, 0.0F) + kEven);
  return (ankle_weight * by_ankle + ball_weight * by_ball) / (ankle_weight + ball_weight);
}

}  // namespace

std::vector<AnkleGoals> compute_ankle_goals(const SourceMotion& source,
                                            const motion::Skeleton& skeleton,
                                            const std::vector<SourceFrame>& frames,
                                            float interval_s, float scale) {
  std::vector<AnkleGoals> goals(frames.size());
  for (std::size_t side = 0; side < 2; ++side) {
    const Foot foot = foot_of(skeleton, side == 0 ? motion::Side::left : motion::Side::right);
    AnkleTracker follower(interval_s);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const SourceFoot& from = frames[k].foot[side];
      const Quaternionf& orientation = frames[k].orientation[foot.roles.foot];
      const Vector3f to_ball = orientation * foot.to_ball;
      const float ankle_lift = scale * (from.ankle.z() - source.ankle_height_m[side]);
      const float ball_lift = scale * (from.ball.z() - source.ball_height_m[side]);
      Vector3f& goal = goals[k][side];
      goal = scale * from.ankle;
      goal.head<2>() += follower.follow(scale * from.ankle, scale * from.ball, to_ball.head<2>(),
                                        std::min(ankle_lift, ball_lift));
      goal.z() = ankle_height(foot, to_ball, ankle_lift, ball_lift);
      goal.z() = std::max(goal.z(), lowest_ankle(foot, to_ball, orientation));
    }
  }
  return goals;
}

}  // namespace flinch::database
