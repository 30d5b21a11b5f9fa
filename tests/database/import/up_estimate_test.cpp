// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "database/import/source_motion.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "tests/database/import/synthetic_figure.h"

namespace flinch::database {
namespace {

using Eigen::Vector3f;
using motion::Pose;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::synthetic_bvh;
using tests::SyntheticRig;

// The SourceReport of a file whose figure is in one pose all the time.
SourceReport report_of(const Pose& pose, const SyntheticRig& rig = {},
                       const SourceOptions& options = {}) {
  const std::vector<Pose> poses(10, pose);
  const motion::Skeleton skeleton = motion::default_character().skeleton;
  return analyse_source(synthetic_bvh(skeleton, rig, poses, 1.0 / 30), options).report;
}

Pose standing() {
  return motion::rest_pose(motion::default_character().skeleton);
}

// On toes and hands, the arms straight down.
Pose plank() {
  Pose pose = standing();
  pose.root_position.z() = 0.4F;
  pose.rotation[Role::pelvis] = rotation_about(Vector3f::UnitY(), radians(75));
  for (auto [arm, side] : {std::pair{Role::left_upper_arm, 1.0F}, {Role::right_upper_arm, -1.0F}}) {
    pose.rotation[arm] = rotation_about(Vector3f::UnitZ(), side * radians(-90));
  }
  return pose;
}

Pose on_the_back() {
  Pose pose = standing();
  pose.root_position.z() = 0.1F;
  pose.rotation[Role::pelvis] = rotation_about(Vector3f::UnitY(), radians(-90));
  return pose;
}

TEST(UpAxis, IsThatOfOffsetsThatStandWhileTheFigureNeverDoes) {
  for (const Pose& pose : {plank(), on_the_back()}) {
    const SourceReport report = report_of(pose);
    EXPECT_EQ(name_of(report.up), "y");
    EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("up is taken to be y, but it may be")));
  }
}

// A figure made with Y up and recorded with Z up.
TEST(UpAxis, IsThatOfAMotionThatStandsOnTheGround) {
  SyntheticRig rig;
  rig.axes.setIdentity();
  rig.rest.rotation[Role::pelvis] = rotation_about(Vector3f::UnitX(), radians(-90));
  for (float yaw : {0.0F, 90.0F, 180.0F, 270.0F}) {
    Pose pose = standing();
    pose.root_position.y() = 2;
    pose.rotation[Role::pelvis] = rotation_about(Vector3f::UnitZ(), radians(yaw));
    const SourceReport report = report_of(pose, rig);
    EXPECT_EQ(name_of(report.up), "z") << yaw;
    EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("up is taken to be z, but it may be y")));
  }
}

TEST(UpAxis, NeedsNoNoteWhereOffsetsAndMotionAgreeOrItIsGiven) {
  EXPECT_THAT(report_of(standing()).warnings, IsEmpty());
  SourceOptions options;
  options.up = UpAxis::y;
  EXPECT_THAT(report_of(plank(), {}, options).warnings, IsEmpty());
}

}  // namespace
}  // namespace flinch::database
