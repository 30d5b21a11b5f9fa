// SPDX-License-Identifier: MIT
#include "reaction/reaction.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reaction/recovery.h"
#include "tests/reaction/reaction_player.h"

namespace flinch::reaction {
namespace {

using motion::Body;
using motion::Role;
using scenes::aimed_at;
using scenes::cases;
using scenes::character;
using scenes::distance;
using scenes::figure_model;
using scenes::frames_of;
using scenes::kFrame_s;
using scenes::motions;
using scenes::play;
using scenes::pose_at;
using scenes::ReactionCase;

TEST(Reaction, ReturnsToTheMotionAtTheEndOfTheSchedule) {
  const double over_s = scenes::kLead_s + duration_s(RecoverySchedule{});
  int returned = 0;
  for (const ReactionCase& reaction_case : cases()) {
    // The reaction returns to another motion than the one that it tracks.
    const motion::Motion& other = motions()[(&reaction_case - cases().data()) % 6].motion;
    Reaction reaction(figure_model());
    scenes::begin(reaction, reaction_case);
    motion::Pose returning;
    for (int k = 1; k * kFrame_s < over_s + 2 * kFrame_s; ++k) {
      const double time_s = reaction_case.begin_s + k * kFrame_s;
      returning = pose_at(other, time_s);
      reaction.advance(kFrame_s, pose_at(*reaction_case.motion, time_s), returning);
    }
    EXPECT_EQ(reaction.phase(), ReactionPhase::over);
    EXPECT_LT(distance(reaction.pose(), returning), 1e-3);
    for (Role role : motion::kRoles) {
      EXPECT_LT(reaction.pose().rotation[role].angularDistance(returning.rotation[role]),
                0.1F * scenes::kDegrees);
    }
    ++returned;
  }
  EXPECT_GT(returned, 40);
}

/// Returns, frame by frame, the largest change of a joint's velocity relative to the motion from
/// one frame to the next, m/s.
std::vector<double> velocity_changes(const std::vector<motion::Pose>& poses,
                                     const ReactionCase& reaction_case) {
  std::vector<double> changes;
  std::vector<motion::PerRole<Eigen::Vector3f>> off;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto shown = frames_of(poses[k]);
    const auto wanted = frames_of(
        pose_at(*reaction_case.motion, reaction_case.begin_s + static_cast<double>(k) * kFrame_s));
    off.emplace_back();
    for (Role role : motion::kRoles) {
      off.back()[role] = shown.position[role] - wanted.position[role];
    }
    double most = 0;
    for (Role role : motion::kRoles) {
      const Eigen::Vector3f before =
          k > 1 ? Eigen::Vector3f(off[k - 1][role] - off[k - 2][role]) : Eigen::Vector3f::Zero();
      if (k == 0) continue;
      most = std::max(
          most, static_cast<double>((off[k][role] - off[k - 1][role] - before).norm()) / kFrame_s);
    }
    changes.push_back(most);
  }
  return changes;
}

TEST(Reaction, PoseIsContinuousAtBeginAndEnd) {
  const RecoverySchedule schedule;
  for (const ReactionCase& reaction_case : cases()) {
    Reaction reaction(figure_model());
    const auto poses = play(reaction, reaction_case, 0.9);
    EXPECT_LT(distance(poses.front(), pose_at(*reaction_case.motion, reaction_case.begin_s)), 1e-5);
    const auto changes = velocity_changes(poses, reaction_case);
    EXPECT_LT(changes[1], 0.3);  // the contact comes after the first frame
    for (std::size_t k = 2; k < changes.size(); ++k) {
      const double since_contact_s = static_cast<double>(k) * kFrame_s - scenes::kLead_s;
      // A hand that is hit may reach several m/s, and may strike another part.
      EXPECT_LT(changes[k], since_contact_s < schedule.simulation_only_s + kFrame_s ? 8 : 0.5)
          << since_contact_s << " s after the contact";
    }
  }
}

bool is_hit_on_the_leg(const Reaction& reaction, Role foot) {
  for (Body body = body_of(foot); body != Body::pelvis; body = *parent_of(body)) {
    if (reaction.impulse()[body] > 0) return true;
  }
  return false;
}

TEST(Reaction, StandingFeetSlideLessThanTheBound) {
  int feet = 0;
  for (const ReactionCase& reaction_case : cases()) {
    Reaction reaction(figure_model());
    const auto poses = play(reaction, reaction_case, 0.8);
    for (Role foot : {Role::left_foot, Role::right_foot}) {
      if (is_hit_on_the_leg(reaction, foot)) continue;
      const auto first = frames_of(poses.front()).position[foot];
      if ((frames_of(reaction_case.motion->poses.back()).position[foot] - first).norm() > 1e-3F)
        continue;
      ++feet;
      for (const motion::Pose& pose : poses) {
        EXPECT_LT((frames_of(pose).position[foot] - first).norm(), 0.003F);
      }
    }
  }
  EXPECT_GT(feet, 30);
}

TEST(Reaction, KeepsBoneLengths) {
  Reaction reaction(figure_model());
  for (const motion::Pose& pose : play(reaction, aimed_at(Body::left_hand, {-30, 0, 0}), 0.4)) {
    const auto frames = frames_of(pose);
    for (Role role : motion::kRoles) {
      EXPECT_NEAR(pose.rotation[role].norm(), 1, 1e-5);
      const auto parent = parent_of(role);
      if (!parent) continue;
      EXPECT_NEAR((frames.position[role] - frames.position[*parent]).norm(),
                  character().skeleton.offset[role].norm(), 1e-5);
    }
  }
}

}  // namespace
}  // namespace flinch::reaction
