// SPDX-License-Identifier: MIT
#include "database/import/plausibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "database/import/source_character.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "tests/database/import/synthetic_figure.h"
#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using motion::Pose;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::error_of;
using tests::synthetic_bvh;
using tests::SyntheticRig;

constexpr double kTakeFrameTime_s = 1.0 / 30;

// Stands with bent knees and hanging arms, and sways by 2 cm.
std::vector<Pose> swaying(int count = 60) {
  const motion::Skeleton skeleton = motion::default_character().skeleton;
  std::vector<Pose> poses;
  for (int k = 0; k < count; ++k) {
    Pose pose = motion::rest_pose(skeleton);
    pose.root_position.y() += 0.02F * std::sin(0.2F * static_cast<float>(k));
    pose.rotation[Role::left_upper_arm] = rotation_about(Vector3f::UnitX(), radians(-80));
    pose.rotation[Role::right_upper_arm] = rotation_about(Vector3f::UnitX(), radians(80));
    pose.rotation[Role::left_forearm] = rotation_about(-Vector3f::UnitZ(), radians(20));
    pose.rotation[Role::right_forearm] = rotation_about(Vector3f::UnitZ(), radians(20));
    poses.push_back(pose);
  }
  return poses;
}

Bvh file_of(const std::vector<Pose>& poses, const SyntheticRig& rig = {}) {
  return synthetic_bvh(motion::default_character().skeleton, rig, poses, kTakeFrameTime_s);
}

std::vector<std::string> notes_on(const Bvh& bvh, const SourceOptions& options = {}) {
  return analyse_source(bvh, options).report.warnings;
}

std::vector<std::string> notes_on_motion(const Bvh& bvh, const SourceOptions& options = {}) {
  const Source source = analyse_source(bvh, options);
  const SourceMotion motion = source_motion(source);
  const motion::Figure figure = motion::make_figure(character_of(source));
  const Segment whole{0, motion.duration_s(), 0};
  motion::Clip clip;
  clip.motion = retarget(motion, figure.skeleton(), whole, 30);
  return judge_motion({source, motion, whole, figure, clip});
}

void scale_offset(Bvh& bvh, const std::string& name, double factor) {
  for (BvhJoint& joint : bvh.joints) {
    if (joint.name == name) joint.offset *= factor;
  }
}

TEST(Plausibility, HasNothingToSayOfAHumanWhoMoves) {
  EXPECT_THAT(notes_on(file_of(swaying())), IsEmpty());
  EXPECT_THAT(notes_on_motion(file_of(swaying())), IsEmpty());
}

TEST(Plausibility, TellsAStatureThatNoAdultHas) {
  SourceOptions options;
  options.unit = LengthUnit::inch;
  // 175 inches; 23 kg/m^2 times 4.445 m squared.
  EXPECT_THAT(
      notes_on(file_of(swaying()), options),
      ElementsAre(AllOf(HasSubstr("4.4"), HasSubstr("45"), HasSubstr("kg"), HasSubstr("--unit"))));
}

TEST(Plausibility, TellsBonesOutOfProportion) {
  Bvh bvh = file_of(swaying());
  for (const char* name : {"left_forearm", "right_forearm"}) scale_offset(bvh, name, 0.5);
  EXPECT_THAT(notes_on(bvh), ElementsAre(AllOf(HasSubstr("upper arm"), HasSubstr("--roles"))));
}

TEST(Plausibility, TellsSidesThatDiffer) {
  Bvh bvh = file_of(swaying());
  scale_offset(bvh, "left_foot", 1.2);  // the shin
  EXPECT_THAT(notes_on(bvh), Contains(AllOf(HasSubstr("left_shin"), HasSubstr("right_shin"))));
}

// A left-handed file's numbers, read as right-handed ones: each offset and position is mirrored,
// and each rotation with it. The mirror keeps the names of the sides.
Bvh left_handed(Bvh bvh) {
  for (BvhJoint& joint : bvh.joints) {
    joint.offset.z() *= -1;
    for (Vector3d& end : joint.end_sites) end.z() *= -1;
  }
  for (int frame = 0; frame < bvh.frame_count; ++frame) {
    for (const BvhJoint& joint : bvh.joints) {
      for (std::size_t i = 0; i < joint.channels.size(); ++i) {
        const BvhChannel channel = joint.channels[i];
        const bool changes_sign = channel == BvhChannel::z_position ||
                                  channel == BvhChannel::x_rotation ||
                                  channel == BvhChannel::y_rotation;
        const std::size_t column = static_cast<std::size_t>(joint.first_channel) + i;
        if (changes_sign) {
          bvh.values[static_cast<std::size_t>(frame * bvh.channel_count) + column] *= -1;
        }
      }
    }
  }
  return bvh;
}

TEST(Plausibility, TellsALeftHandedFile) {
  const Bvh bvh = left_handed(file_of(swaying()));
  EXPECT_THAT(notes_on(bvh), Contains(AllOf(HasSubstr("backward"), HasSubstr("--roles"))));
  SourceOptions exchanged;
  for (Role role : motion::kRoles) {
    exchanged.roles[role] = std::string(motion::name_of(motion::mirrored(role)));
  }
  EXPECT_THAT(notes_on(bvh, exchanged), IsEmpty());
  EXPECT_THAT(notes_on_motion(bvh, exchanged), IsEmpty());
}

void multiply_angles(Bvh& bvh, double factor) {
  for (const BvhJoint& joint : bvh.joints) {
    for (std::size_t i = 0; i < joint.channels.size(); ++i) {
      if (joint.channels[i] < BvhChannel::x_rotation) continue;
      const auto width = static_cast<std::size_t>(bvh.channel_count);
      for (std::size_t at = static_cast<std::size_t>(joint.first_channel) + i;
           at < bvh.values.size(); at += width) {
        bvh.values[at] *= factor;
      }
    }
  }
}

TEST(Plausibility, TellsAnglesInRadians) {
  Bvh bvh = file_of(swaying());
  multiply_angles(bvh, radians(1.0));
  EXPECT_THAT(notes_on(bvh),
              Contains(AllOf(HasSubstr("no rotation is beyond 4"), HasSubstr("by 57.2958"))));
  multiply_angles(bvh, motion::degrees(1.0));
  EXPECT_THAT(notes_on(bvh), IsEmpty());
}

// In degrees a figure that hardly moves has small angles too. As radians, no human has them.
TEST(Plausibility, DoesNotTakeSomeoneWhoHardlyMovesForRadians) {
  for (const float sway_deg : {0.2F, 2.0F, 6.0F}) {
    std::vector<Pose> poses;
    for (int k = 0; k < 120; ++k) {
      Pose pose = motion::rest_pose(motion::default_character().skeleton);
      const float sway = radians(sway_deg) * std::sin(0.07F * static_cast<float>(k));
      for (const Role role : {Role::abdomen, Role::chest, Role::neck, Role::left_thigh,
                              Role::right_thigh, Role::left_shin, Role::right_shin}) {
        pose.rotation[role] = rotation_about(Vector3f::UnitY(), sway);
      }
      for (const Role role : {Role::left_upper_arm, Role::right_upper_arm}) {
        pose.rotation[role] = rotation_about(Vector3f::UnitX(), sway);
      }
      poses.push_back(pose);
    }
    EXPECT_THAT(notes_on(file_of(poses)), IsEmpty()) << sway_deg;
  }
}

TEST(Plausibility, TellsARateThatNoCaptureHas) {
  for (double frame_time_s : {1.0, 0.0001}) {
    Bvh bvh = file_of(swaying());
    bvh.frame_time_s = frame_time_s;
    EXPECT_THAT(notes_on(bvh), ElementsAre(HasSubstr("--rate-of-file")));
  }
}

TEST(Plausibility, TellsATPoseInFrontAndWhereItEnds) {
  std::vector<Pose> poses = swaying(60);
  poses[0] = motion::rest_pose(motion::default_character().skeleton);
  poses[0].root_position.x() -= 9;
  EXPECT_THAT(notes_on_motion(file_of(poses)),
              ElementsAre(AllOf(HasSubstr("frame 1 is a T-pose, 9.0"), HasSubstr("from frame 2;"),
                                HasSubstr("--skip-first"))));
  for (int k = 1; k < 10; ++k) poses[static_cast<std::size_t>(k)] = poses[0];
  EXPECT_THAT(
      notes_on_motion(file_of(poses)),
      ElementsAre(AllOf(HasSubstr("frames 1 to 10 are a T-pose"), HasSubstr("--frames 11:60"))));
}

// A rest pose with hanging arms is no T-pose.
TEST(Plausibility, TellsAnotherPoseInFrontThatIsFarAway) {
  std::vector<Pose> poses = swaying();
  poses[0].root_position.x() -= 3;
  EXPECT_THAT(notes_on_motion(file_of(poses)),
              ElementsAre(AllOf(HasSubstr("frame 1 is 3.0"), HasSubstr("--skip-first"))));
}

TEST(Plausibility, TellsFramesThatAreElsewhere) {
  std::vector<Pose> poses = swaying(90);
  for (std::size_t k : {40U, 41U}) poses[k].root_position.x() += 2500;
  EXPECT_THAT(notes_on_motion(file_of(poses)),
              ElementsAre(AllOf(HasSubstr("frames 41 to 42"), HasSubstr("2.5 km"),
                                HasSubstr("--frames 43:90"))));
}

TEST(Plausibility, AClipThatGoesTooFarIsRefusedWithTheFramesToKeep) {
  const auto refusal_of = [](const std::vector<Pose>& poses) {
    const Source source = analyse_source(file_of(poses));
    const SourceMotion motion = source_motion(source);
    const motion::Figure figure = motion::make_figure(character_of(source));
    const Segment whole{0, motion.duration_s(), 0};
    motion::Clip clip;
    clip.name = "take";
    clip.motion = retarget(motion, figure.skeleton(), whole, 30);
    return error_of([&] { require_near("a.bvh", {source, motion, whole, figure, clip}); });
  };
  std::vector<Pose> away = swaying(90);
  EXPECT_EQ(refusal_of(away), "");
  for (std::size_t k : {40U, 41U}) away[k].root_position.x() += 2500;
  EXPECT_THAT(refusal_of(away), AllOf(HasSubstr("a.bvh: the clip \"take\" goes farther than 1 km"),
                                      HasSubstr("--frames 43:90, or frames in a manifest")));
  // On a train: 6 m/s, which is no jump, but over three minutes.
  std::vector<Pose> train = swaying(6000);
  for (std::size_t k = 0; k < train.size(); ++k) {
    train[k].root_position.x() += 0.2F * static_cast<float>(k);
  }
  EXPECT_THAT(refusal_of(train), HasSubstr("--frames :5001, or"));
}

TEST(Plausibility, TellsAJumpForGood) {
  std::vector<Pose> poses = swaying(90);
  for (std::size_t k = 60; k < poses.size(); ++k) poses[k].root_position.x() += 2;
  EXPECT_THAT(notes_on_motion(file_of(poses)),
              ElementsAre(AllOf(HasSubstr("frames 60 to 61: the body jumps by 2.0"),
                                HasSubstr("--frames 1:60"))));
}

TEST(Plausibility, NamesFramesAsTheFileNumbersThem) {
  std::vector<Pose> poses = swaying(90);
  for (std::size_t k : {40U, 41U}) poses[k].root_position.x() += 2500;
  SourceOptions options;
  options.frames.range = FrameRange{11, 80};
  EXPECT_THAT(notes_on_motion(file_of(poses), options),
              ElementsAre(AllOf(HasSubstr("frames 41 to 42"), HasSubstr("--frames 43:80"))));
}

TEST(Plausibility, TellsJointsThatAreBeyondTheirLimitsMostOfTheTime) {
  std::vector<Pose> poses = swaying();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const bool is_twisted = 5 * k > 2 * poses.size();
    if (is_twisted) poses[k].rotation[Role::head] = rotation_about(Vector3f::UnitZ(), radians(170));
  }
  EXPECT_THAT(notes_on_motion(file_of(poses)),
              Contains(AllOf(HasSubstr("neck is"), HasSubstr("half of the time"))));
}

TEST(Plausibility, TellsFeetThatSlide) {
  std::vector<Pose> poses = swaying(90);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    poses[k].root_position.x() += 0.03F * static_cast<float>(k);
  }
  EXPECT_THAT(notes_on_motion(file_of(poses)),
              ElementsAre(AllOf(HasSubstr("a sole slips"), HasSubstr("--frames"))));
}

}  // namespace
}  // namespace flinch::database
