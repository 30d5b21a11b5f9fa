// SPDX-License-Identifier: MIT
#include "database/annotate/draft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "database/annotate/contact_sheet.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "tests/database/annotate/take_scene.h"

namespace flinch::database {
namespace {

using motion::Pose;
using motion::Side;
using motion::Target;
using tests::pulse;
using tests::standing;
using tests::take_of;

constexpr float kPi = std::numbers::pi_v<float>;

// The only clip of a take.
DraftClip only_clip(const Take& take) {
  const Draft draft = draft_of(take);
  EXPECT_EQ(draft.clips.size(), 1U);
  return draft.clips.at(0);
}

void expect_times(const DraftClip& clip, double begin_s, double peak_s, double end_s) {
  // A twentieth of a minimum-jerk movement is behind after 0.189 of its time.
  EXPECT_NEAR(clip.onset_s, begin_s + 0.189 * (peak_s - begin_s), 0.03);
  EXPECT_NEAR(clip.peak_s, peak_s, 0.05);
  EXPECT_NEAR(clip.end_s, end_s, 0.15);
}

Take duck_at(double begin_s) {
  return take_of(4, [=](double time_s) {
    Pose pose = standing();
    pose.root_position.z() -= 0.45F * pulse(time_s, begin_s, begin_s + 0.5, begin_s + 1.1);
    return pose;
  });
}

Pose with_raised_left_arm(float share) {
  Pose pose = standing();
  motion::set_arm(pose, Side::left, {.flexion = share * 2.6F});
  return pose;
}

TEST(DraftTest, HeadThatSinksIsADuck) {
  const DraftClip clip = only_clip(duck_at(1.5));
  EXPECT_EQ(clip.kind.value, MovementKind::duck);
  EXPECT_EQ(clip.protection.target.value, Target::head);
  EXPECT_EQ(clip.protection.direction.value, 0);
  EXPECT_EQ(clip.protection.degree, motion::Degree::exaggerated);
  EXPECT_EQ(clip.name, "duck_high_front_1");
  expect_times(clip, 1.5, 2.0, 2.6);
}

TEST(DraftTest, TimesCountFromTheStartOfTheFile) {
  Take take = duck_at(1.5);
  const DraftClip clip = only_clip(take);
  take.start_s = 0.25;
  const DraftClip later = only_clip(take);
  EXPECT_DOUBLE_EQ(later.onset_s, clip.onset_s + 0.25);
  EXPECT_DOUBLE_EQ(later.peak_s, clip.peak_s + 0.25);
}

TEST(DraftTest, RaisedHandIsABlockOnItsSide) {
  const DraftClip clip = only_clip(
      take_of(4, [](double time_s) { return with_raised_left_arm(pulse(time_s, 1.5, 2.1, 2.8)); }));
  EXPECT_EQ(clip.kind.value, MovementKind::block);
  EXPECT_EQ(clip.protection.target.value, Target::head);
  EXPECT_FLOAT_EQ(clip.protection.direction.value, kPi / 4);
  EXPECT_NEAR(clip.onset_s, 1.5, 0.15);
  EXPECT_NEAR(clip.peak_s, 2.1, 0.1);
}

TEST(DraftTest, SlowTravelIsAStepAwayFromTheThreat) {
  const DraftClip clip = only_clip(take_of(8, [](double time_s) {
    Pose pose = standing();
    pose.root_position.y() += 0.4F * pulse(time_s, 1.5, 3.2, 4.9);
    return pose;
  }));
  EXPECT_EQ(clip.kind.value, MovementKind::step);
  EXPECT_FLOAT_EQ(clip.protection.direction.value, -kPi / 2);
  EXPECT_NEAR(clip.peak_s, 3.2, 0.1);
}

TEST(DraftTest, TravelThatFeetCannotGiveIsAPush) {
  const DraftClip clip = only_clip(take_of(6, [](double time_s) {
    Pose pose = standing();
    pose.root_position.x() += 0.5F * tests::minimum_jerk(time_s, 2.0, 2.5);
    return pose;
  }));
  EXPECT_EQ(clip.kind.value, MovementKind::push);
  EXPECT_FLOAT_EQ(clip.protection.direction.value, kPi);
  EXPECT_NEAR(clip.onset_s, 2.0, 0.1);
}

TEST(DraftTest, LiftedFootIsALiftOfTheLegs) {
  const DraftClip clip = only_clip(take_of(4, [](double time_s) {
    Pose pose = standing();
    const float angle = 1.5F * pulse(time_s, 1.5, 2.1, 2.8);
    pose.rotation[motion::Role::left_thigh] =
        motion::rotation_about(-Eigen::Vector3f::UnitY(), angle);
    return pose;
  }));
  EXPECT_EQ(clip.kind.value, MovementKind::lift);
  EXPECT_EQ(clip.protection.target.value, Target::legs);
  EXPECT_NEAR(clip.peak_s, 2.1, 0.05);
}

TEST(DraftTest, WayOutAndWayBackAreOneMovement) {
  // It holds for half a second where it has gone.
  const DraftClip clip = only_clip(take_of(5, [](double time_s) {
    Pose pose = standing();
    pose.root_position.z() -=
        0.45F * (tests::minimum_jerk(time_s, 1.5, 2.0) - tests::minimum_jerk(time_s, 2.6, 3.2));
    return pose;
  }));
  EXPECT_NEAR(clip.start_s, 1.5, 0.15);
  EXPECT_NEAR(clip.end_s, 3.2, 0.15);
}

TEST(DraftTest, MovementsOfAStanceThatIsNeverStillAreFound) {
  // A guard that bobs by 3 cm at 1.5 Hz, and a duck every 5 s.
  const Draft draft = draft_of(take_of(20, [](double time_s) {
    Pose pose = standing();
    pose.root_position.x() +=
        static_cast<float>(0.06 * std::sin(2 * std::numbers::pi * 1.5 * time_s));
    for (double begin_s : {4.0, 9.0, 14.0}) {
      pose.root_position.z() -= 0.45F * pulse(time_s, begin_s, begin_s + 0.5, begin_s + 1.1);
    }
    return pose;
  }));
  ASSERT_EQ(draft.clips.size(), 3U);
  EXPECT_TRUE(draft.still.empty());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(draft.clips[k].kind.value, MovementKind::duck);
    EXPECT_NEAR(draft.clips[k].peak_s, 4.5 + 5 * static_cast<double>(k), 0.1);
    EXPECT_NEAR(draft.clips[k].onset_s, 4.0 + 5 * static_cast<double>(k), 0.2);
  }
}

TEST(DraftTest, WhatFitsNoKindIsUncertain) {
  const DraftClip clip = only_clip(take_of(4, [](double time_s) {
    Pose pose = standing();
    motion::set_arm(pose, Side::left, {.flexion = 0.9F * pulse(time_s, 1.5, 2.1, 2.8)});
    return pose;
  }));
  EXPECT_LT(clip.kind.confidence, 0.2F);
}

TEST(DraftTest, IdleOfAMovingStanceIsNotTheHoldOfADuck) {
  // The guard sways at 0.3 m/s on average; a duck is held still for 0.3 s.
  const Draft draft = draft_of(take_of(12, [](double time_s) {
    Pose pose = standing();
    const bool holds = time_s > 6.2 && time_s < 6.8;
    const double sway_s = holds ? 0 : time_s;
    pose.root_position.x() += static_cast<float>(0.05 * std::sin(10 * sway_s));
    pose.root_position.z() -=
        0.45F * (tests::minimum_jerk(time_s, 5.8, 6.2) - tests::minimum_jerk(time_s, 6.6, 7.1));
    return pose;
  }));
  EXPECT_TRUE(draft.idle.end_s < 5.8 || draft.idle.start_s > 7.1);
}

TEST(DraftTest, TakeThatIsNeverStillIsRefused) {
  const Take take = take_of(4, [](double time_s) {
    Pose pose = standing();
    pose.root_position.x() += static_cast<float>(1.2 * time_s);
    return pose;
  });
  EXPECT_THROW(draft_of(take), Error);
}

TEST(DraftTest, StandingStillHoldsAnIdleAndNoClip) {
  const Draft draft = draft_of(take_of(3, [](double) { return standing(); }));
  EXPECT_TRUE(draft.clips.empty());
  EXPECT_NEAR(draft.idle.end_s - draft.idle.start_s, 3, 0.05);
  EXPECT_GT(draft.idle.confidence, 0.9F);
}

TEST(ContactSheetTest, HasAStripForTheIdleAndForEachClip) {
  Take take = duck_at(1.5);
  take.source.path = "a<b>&c.bvh";
  const std::string svg = contact_sheet_svg(take, draft_of(take));
  EXPECT_NE(svg.find(">duck_high_front_1<"), std::string::npos);
  EXPECT_NE(svg.find(">idle<"), std::string::npos);
  EXPECT_NE(svg.find("a&lt;b&gt;&amp;c.bvh"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace flinch::database
