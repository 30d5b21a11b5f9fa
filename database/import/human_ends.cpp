// SPDX-License-Identifier: MIT
#include "database/import/human_ends.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::database {
namespace {

using Eigen::Vector3d;
using motion::Role;

struct Range {
  double min, max;
  bool contains(double value) const { return value >= min && value <= max; }
};

// Distance from the ankle over the leg's length. The default character has the ball at 0.16 and the
// tip of the toes at 0.25; skeletons of recorded motion have the ball at 0.11 to 0.21.
constexpr Range kBallJoint{0.08, 0.26};
constexpr Range kBallEnd{0.08, 0.215};
constexpr Range kToeTip{0.215, 0.45};
// Degrees below the horizontal. Skeletons of recorded motion have the ball up to 43 below the
// ankle; in a standing pose taken from the motion the heel may be up as well.
constexpr Range kFootSlope{-25, 70};

// Over the length of the segment before, and degrees to it. The default character's hand is 0.70 of
// the forearm, its forearm 0.95 of the upper arm, its toes 0.60 of the way to the ball.
constexpr Range kHand{0.2, 1.3};
constexpr Range kForearm{0.6, 1.5};
constexpr Range kToes{0.2, 1.2};
constexpr double kMaxHandAngle = 75;
constexpr double kMaxToeAngle = 60;

// The ball of the foot from the ankle, forward and up, as a fraction of the leg's length: the mean
// of recorded skeletons.
const Vector3d kMeanBall(0.15, 0, -0.055);
// How far the ball is on the way from the ankle to the tip of the toes, along the ground, in the
// default character.
constexpr double kBallShare = 0.47 / 0.75;

double angle_deg(const Vector3d& one, const Vector3d& other) {
  const double cosine = one.normalized().dot(other.normalized());
  return motion::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

class EndJudge {
 public:
  EndJudge(SourceFigure figure, const StandingPose& standing)
      : figure_(std::move(figure)),
        standing_(standing),
        frame_(figure_frame(figure_, standing.joints, standing.to_world)),
        leg_(leg_length(frame_)) {}

  void judge_arm(Role upper_arm, Role forearm, Role hand) {
    if (!figure_.has(hand)) {
      const double ratio = segment(forearm).norm() / segment(upper_arm).norm();
      if (!kForearm.contains(ratio)) figure_.end[forearm].reset();
      return;
    }
    const bool possible = kHand.contains(segment(hand).norm() / segment(forearm).norm()) &&
                          angle_deg(segment(hand), segment(forearm)) <= kMaxHandAngle;
    if (!possible) figure_.end[hand].reset();
  }

  void judge_foot(Role foot, Role toes) {
    if (figure_.has(toes)) {
      if (is_at_foot(segment(foot), kBallJoint)) {
        judge_toes(foot, toes);
        return;
      }
      drop_toes(foot, toes);
    }
    if (!figure_.end[foot]) {
      put_ball(foot, leg_ * kMeanBall);
      return;
    }
    const Vector3d end = segment(foot);
    if (is_end_of_foot(end, kBallEnd)) return;
    Vector3d ball = leg_ * kMeanBall;
    if (is_end_of_foot(end, kToeTip)) {
      ball = end;
      ball.head<2>() *= kBallShare;
    }
    put_ball(foot, ball);
  }

  SourceFigure result() const { return figure_; }

 private:
  // Returns the vector from a segment's joint to its end, Z up and facing +X.
  Vector3d segment(Role role) const {
    return figure_.end[role] ? Vector3d(point(*figure_.end[role]) - frame_.position[role])
                             : Vector3d::Zero();
  }

  Vector3d point(const Landmark& landmark) const {
    const auto joint = static_cast<std::size_t>(landmark.joint);
    return standing_.to_world * (standing_.joints.position[joint] +
                                 standing_.joints.orientation[joint] * landmark.offset);
  }

  bool is_at_foot(const Vector3d& from_ankle, const Range& distance) const {
    const double slope = motion::degrees(std::atan2(-from_ankle.z(), from_ankle.head<2>().norm()));
    return distance.contains(from_ankle.norm() / leg_) && kFootSlope.contains(slope);
  }

  // A joint is where its bone ends; an End Site may be anywhere, but that of a foot is in front.
  bool is_end_of_foot(const Vector3d& from_ankle, const Range& distance) const {
    constexpr double kForward = 0.3;  // cosine of the angle to straight ahead
    return is_at_foot(from_ankle, distance) &&
           from_ankle.x() > kForward * from_ankle.head<2>().norm();
  }

  // Tails of bones and toes spread sideways do not show the tip.
  void judge_toes(Role foot, Role toes) {
    const bool possible = kToes.contains(segment(toes).norm() / segment(foot).norm()) &&
                          angle_deg(segment(toes), segment(foot)) <= kMaxToeAngle;
    if (!possible) figure_.end[toes].reset();
  }

  // A joint that is not at the ball does not bend the toes. One at the ankle carries the foot.
  void drop_toes(Role foot, Role toes) {
    const std::optional<Landmark> below = figure_.end[toes];
    const bool is_at_ankle = segment(foot).norm() < kBallJoint.min * leg_;
    if (is_at_ankle) {
      figure_.end[foot] = below;
      const bool carries_foot = below && (is_end_of_foot(segment(foot), kBallEnd) ||
                                          is_end_of_foot(segment(foot), kToeTip));
      if (carries_foot) figure_.carrier[foot] = figure_.joint[toes];
    }
    figure_.joint[toes] = figure_.carrier[toes] = -1;
    figure_.end[toes].reset();
  }

  void put_ball(Role foot, const Vector3d& from_ankle) {
    const auto joint = static_cast<std::size_t>(figure_.carrier[foot]);
    const Vector3d ball = standing_.to_world.conjugate() * (frame_.position[foot] + from_ankle);
    figure_.end[foot] =
        Landmark{figure_.carrier[foot], standing_.joints.orientation[joint].conjugate() *
                                            (ball - standing_.joints.position[joint])};
  }

  SourceFigure figure_;
  const StandingPose& standing_;
  const FigureFrame frame_;
  const double leg_;
};

}  // namespace

SourceFigure with_human_ends(SourceFigure figure, const StandingPose& standing) {
  EndJudge judge(std::move(figure), standing);
  judge.judge_arm(Role::left_upper_arm, Role::left_forearm, Role::left_hand);
  judge.judge_arm(Role::right_upper_arm, Role::right_forearm, Role::right_hand);
  judge.judge_foot(Role::left_foot, Role::left_toes);
  judge.judge_foot(Role::right_foot, Role::right_toes);
  return judge.result();
}

}  // namespace flinch::database
