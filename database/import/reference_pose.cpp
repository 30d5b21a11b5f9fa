// SPDX-License-Identifier: MIT
#include "database/import/reference_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/rotation.h"

namespace flinch::database {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::kRoles;
using motion::PerRole;
using motion::Role;

constexpr int kFramesLookedAt = 2000;

struct ArmRoles {
  Role upper_arm, forearm, hand;
};
struct LegRoles {
  Role thigh, shin, foot, toes;
};
constexpr std::array<ArmRoles, 2> kArmRoles{
    {{Role::left_upper_arm, Role::left_forearm, Role::left_hand},
     {Role::right_upper_arm, Role::right_forearm, Role::right_hand}}};
constexpr std::array<LegRoles, 2> kLegRoles{
    {{Role::left_thigh, Role::left_shin, Role::left_foot, Role::left_toes},
     {Role::right_thigh, Role::right_shin, Role::right_foot, Role::right_toes}}};

Vector3d bone(const FigureFrame& frame, Role role) {
  return (frame.end[role] - frame.position[role]).normalized();
}

double cosine_between(const Vector3d& one, const Vector3d& other) {
  return one.normalized().dot(other.normalized());
}

// Measures how far a frame is from standing upright and symmetric; 0 is perfect. Each term is 1 -
// cos of an angle that is 0 when standing, or a difference of heights in leg lengths.
double doubt_of(const FigureFrame& frame) {
  const Vector3d up = Vector3d::UnitZ();
  const Vector3d hips = frame.position[Role::left_thigh] - frame.position[Role::right_thigh];
  const Vector3d shoulders =
      frame.position[Role::left_upper_arm] - frame.position[Role::right_upper_arm];
  double doubt = 1 - cosine_between(frame.position[Role::head] - hip_centre(frame), up);
  doubt += 1 - cosine_between(hips, shoulders);
  for (const LegRoles& leg : kLegRoles) {
    doubt += 1 + bone(frame, leg.thigh).dot(up);
    doubt += 1 + bone(frame, leg.shin).dot(up);
  }
  for (const ArmRoles& arm : kArmRoles) {
    doubt += 0.25 * (1 - bone(frame, arm.upper_arm).dot(bone(frame, arm.forearm)));
  }
  const Vector3d feet = frame.position[Role::left_foot] - frame.position[Role::right_foot];
  const double leg_length =
      (frame.position[Role::left_thigh] - frame.position[Role::left_foot]).norm();
  return doubt + std::abs(feet.z()) / leg_length;
}

// Computes the rotation of each role from the given frame to the T-pose.
class Straightener {
 public:
  Straightener(const SourceFigure& figure, const FigureFrame& frame, bool is_rest)
      : figure_(figure), frame_(frame) {
    for (Quaterniond& turn : turn_) turn.setIdentity();
    if (!is_rest) straighten_trunk();
    for (std::size_t side = 0; side < 2; ++side) {
      straighten_arm(kArmRoles[side], side == 0 ? Vector3d(0, 1, 0) : Vector3d(0, -1, 0));
      straighten_leg(kLegRoles[side]);
    }
  }

  const PerRole<Quaterniond>& turns() const { return turn_; }

 private:
  // In a frame of a motion the trunk leans a little and the shoulders are turned. A rest figure is
  // as its author made it, and is not changed.
  void straighten_trunk() {
    const Vector3d hips = frame_.position[Role::left_thigh] - frame_.position[Role::right_thigh];
    const Vector3d shoulders =
        frame_.position[Role::left_upper_arm] - frame_.position[Role::right_upper_arm];
    const Vector3d neck =
        0.5 * (frame_.position[Role::left_upper_arm] + frame_.position[Role::right_upper_arm]);
    const Vector3d spine = neck - hip_centre(frame_);
    turn_[Role::pelvis] = to_world(spine.normalized(), hips.cross(spine));
    turn_[Role::chest] = to_world(spine.normalized(), shoulders.cross(spine));
    turn_[Role::abdomen] = turn_[Role::pelvis].slerp(0.5, turn_[Role::chest]);
    turn_[Role::left_clavicle] = turn_[Role::chest];
    turn_[Role::right_clavicle] = turn_[Role::chest];
  }

  Quaterniond turn_above(Role role) const {
    const std::optional<Role> parent = parent_in(figure_, role);
    return parent ? turn_[*parent] : Quaterniond::Identity();
  }

  // The parent's rotation, followed by the shortest one that takes the bone to `direction`.
  void align(Role role, const Vector3d& direction) {
    if (!figure_.has(role)) return;
    turn_[role] = turn_above(role);
    if (!figure_.end[role]) return;
    const Vector3d carried = turn_[role] * (frame_.end[role] - frame_.position[role]);
    turn_[role] = motion::rotation_between<double>(carried, direction) * turn_[role];
  }

  void straighten_arm(const ArmRoles& arm, const Vector3d& outward) {
    align(arm.upper_arm, outward);
    align(arm.forearm, outward);
    align(arm.hand, outward);
  }

  void straighten_leg(const LegRoles& leg) {
    align(leg.thigh, -Vector3d::UnitZ());
    align(leg.shin, -Vector3d::UnitZ());
    turn_[leg.foot] = turn_above(leg.foot);
    if (figure_.end[leg.foot]) {
      Vector3d forward = frame_.end[leg.foot] - frame_.position[leg.foot];
      forward.z() = 0;
      turn_[leg.foot] = motion::rotation_between<double>(forward, Vector3d::UnitX());
    }
    turn_[leg.toes] = turn_[leg.foot];
  }

  const SourceFigure& figure_;
  const FigureFrame& frame_;
  PerRole<Quaterniond> turn_;
};

// Rest figures face along an axis: a direction close to one is replaced by that axis.
Vector3d snapped(const Vector3d& direction) {
  const Vector3d axis = direction_of(nearest_axis(direction));
  return direction.normalized().dot(axis) > std::cos(0.25) ? axis : direction;
}

Quaterniond to_facing_x(const SourceFigure& figure, const BvhFrame& frame, const Vector3d& up,
                        bool is_rest) {
  const FigureFrame as_it_is = figure_frame(figure, frame, Quaterniond::Identity());
  const Vector3d forward = leftward(as_it_is).cross(up);
  return to_world(up, is_rest ? snapped(forward) : forward);
}

}  // namespace

bool stands_like_human(const SourceFigure& figure, const FigureFrame& frame) {
  constexpr double kStraight = 0.85;
  const Vector3d up = Vector3d::UnitZ();
  const Vector3d hips = frame.position[Role::left_thigh] - frame.position[Role::right_thigh];
  if (hips.norm() == 0 || std::abs(cosine_between(hips, up)) > 0.5) return false;
  if (cosine_between(frame.position[Role::head] - hip_centre(frame), up) < kStraight) return false;
  for (const LegRoles& leg : kLegRoles) {
    if (bone(frame, leg.thigh).dot(up) > -kStraight) return false;
    if (bone(frame, leg.shin).dot(up) > -kStraight) return false;
  }
  return std::all_of(kArmRoles.begin(), kArmRoles.end(), [&](const ArmRoles& arm) {
    const Vector3d upper_arm = bone(frame, arm.upper_arm);
    if (upper_arm.dot(up) > 0.5) return false;
    return !figure.end[arm.forearm] || upper_arm.dot(bone(frame, arm.forearm)) > kStraight;
  });
}

std::optional<StandingPose> standing_rest_figure(const Bvh& bvh, const SourceFigure& figure) {
  const BvhFrame rest = rest_frame(bvh);
  const Vector3d rest_up =
      direction_of(nearest_axis(feet_to_head(figure_frame(figure, rest, Quaterniond::Identity()))));
  const Quaterniond turn = to_facing_x(figure, rest, rest_up, true);
  if (!stands_like_human(figure, figure_frame(figure, rest, turn))) return std::nullopt;
  return StandingPose{rest, turn, -1, 0};
}

StandingPose find_standing_pose(const Bvh& bvh, const SourceFigure& figure, UpAxis up) {
  if (const std::optional<StandingPose> rest = standing_rest_figure(bvh, figure)) return *rest;
  const int step = std::max(1, bvh.frame_count / kFramesLookedAt);
  double min_doubt = std::numeric_limits<double>::infinity();
  int best = 0;
  for (int number = 0; number < bvh.frame_count; number += step) {
    const FigureFrame frame = figure_frame(figure, forward_kinematics(bvh, number), to_world(up));
    const double doubt = doubt_of(frame);
    if (doubt >= min_doubt) continue;
    min_doubt = doubt;
    best = number;
  }
  const BvhFrame most_upright = forward_kinematics(bvh, best);
  return {most_upright, to_facing_x(figure, most_upright, direction_of(up), false), best,
          min_doubt};
}

bool feet_point_backward(const SourceFigure& figure, const StandingPose& standing) {
  constexpr double kHasLength = 0.05;  // of the leg's length; stubs point nowhere
  const FigureFrame frame = figure_frame(figure, standing.joints, standing.to_world);
  return std::ranges::all_of(kLegRoles, [&](const LegRoles& leg) {
    if (!figure.end[leg.foot]) return false;
    const Vector3d foot = frame.end[leg.foot] - frame.position[leg.foot];
    return foot.norm() > kHasLength * leg_length(frame) && foot.x() < -0.5 * foot.norm();
  });
}

ReferencePose make_reference_pose(const SourceFigure& figure, const StandingPose& standing) {
  const FigureFrame frame = figure_frame(figure, standing.joints, standing.to_world);
  const PerRole<Quaterniond> turn = Straightener(figure, frame, standing.frame < 0).turns();
  ReferencePose reference;
  reference.frame = standing.frame;
  reference.doubt = standing.doubt;
  for (Role role : kRoles) {
    reference.orientation[role].setIdentity();
    reference.position[role].setZero();
    reference.end[role].setZero();
    if (!figure.has(role)) continue;
    reference.orientation[role] = turn[role] * frame.orientation[role];
    if (const std::optional<Role> parent = parent_in(figure, role)) {
      reference.position[role] = reference.position[*parent] +
                                 turn[*parent] * (frame.position[role] - frame.position[*parent]);
    }
    if (!figure.end[role]) continue;
    reference.end[role] =
        reference.position[role] + turn[role] * (frame.end[role] - frame.position[role]);
  }
  return reference;
}

}  // namespace flinch::database
