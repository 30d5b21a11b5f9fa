// SPDX-License-Identifier: MIT
#include "database/export/bvh_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "database/export/euler_angles.h"
#include "database/files/file_io.h"
#include "database/import/bvh.h"
#include "database/import/import.h"
#include "motion/default_character.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/synthetic_library.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector3f;
using motion::kRoles;
using motion::Role;
using testing::HasSubstr;
using tests::error_of;

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

// Rotation from the file's axes (Z forward, X left, Y up) to ours.
Eigen::Matrix3d from_file() {
  Eigen::Matrix3d matrix;
  matrix << Vector3d::UnitZ().transpose(), Vector3d::UnitX().transpose(),
      Vector3d::UnitY().transpose();
  return matrix;
}

std::size_t joint_named(const Bvh& bvh, Role role) {
  for (std::size_t i = 0; i < bvh.joints.size(); ++i) {
    if (bvh.joints[i].name == motion::name_of(role)) return i;
  }
  ADD_FAILURE() << "no joint " << motion::name_of(role);
  return 0;
}

// Angle between two rotations, radians, accurate for small angles.
double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return 2 * std::asin(std::min(1.0, (a - b).norm() / std::sqrt(8)));
}

void expect_read_back(const motion::Physique& character, const motion::Motion& motion,
                      const std::string& what) {
  const Bvh bvh = parse_bvh(bvh_text(character, motion), "written.bvh");
  EXPECT_TRUE(bvh.warnings.empty());
  ASSERT_EQ(bvh.joints.size(), kRoles.size());
  ASSERT_EQ(static_cast<std::size_t>(bvh.frame_count), motion.poses.size());
  EXPECT_DOUBLE_EQ(bvh.frame_time_s, 1 / double{motion.rate_hz});
  double most_m = 0;
  double max_angle = 0;
  for (int k = 0; k < bvh.frame_count; ++k) {
    const motion::JointFrames expected =
        forward_kinematics(character.skeleton, motion.poses[static_cast<std::size_t>(k)]);
    const BvhFrame found = forward_kinematics(bvh, k);
    for (const Role role : kRoles) {
      const std::size_t joint = joint_named(bvh, role);
      const Vector3d position = from_file() * found.position[joint] / 100;
      most_m = std::max(most_m, (position - expected.position[role].cast<double>()).norm());
      const Eigen::Matrix3d turn =
          from_file() * found.orientation[joint].toRotationMatrix() * from_file().transpose();
      max_angle = std::max(
          max_angle,
          angle_between(turn, expected.orientation[role].cast<double>().toRotationMatrix()));
    }
  }
  // The documented bounds; the actual values are printed.
  EXPECT_LT(most_m, 1e-4) << what;
  EXPECT_LT(max_angle / kDegree, 0.01) << what;
  std::printf("%s: read back to %.1e mm and %.1e degrees\n", what.c_str(), 1e3 * most_m,
              max_angle / kDegree);
}

TEST(BvhWriter, RandomMotionRoundTrips) {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    motion::Physique character = motion::default_character();
    character.skeleton = tests::with_crooked_bones(character.skeleton, random);
    motion::Motion motion;
    motion.rate_hz = tests::uniform(random, 10, 240);
    for (int k = 0; k < 30; ++k) motion.poses.push_back(tests::random_pose(random));
    expect_read_back(character, motion, "random " + std::to_string(round));
  }
}

TEST(BvhWriter, AuthoredMotionRoundTrips) {
  const ClipLibrary library = scenes::synthetic_library();
  for (const motion::Clip& clip : library.clips) {
    expect_read_back(library.character, clip.motion, clip.name);
  }
}

// Rotations whose middle angle, about the character's left, is a quarter turn or almost one.
TEST(BvhWriter, GimbalLockRoundTrips) {
  std::mt19937 random(2);
  const motion::Physique character = motion::default_character();
  for (const double off : {0.0, 1e-9, 1e-7, 1e-6, 2e-6, 1e-5, 1e-4, 1e-3}) {
    motion::Motion motion;
    for (int k = 0; k < 30; ++k) {
      motion::Pose pose = motion::rest_pose(character.skeleton);
      for (Eigen::Quaternionf& rotation : pose.rotation) {
        const double sign = tests::uniform(random, -1, 1) < 0 ? -1 : 1;
        const AngleAxisd forward(double{tests::uniform(random, -3, 3)}, Vector3d::UnitX());
        const AngleAxisd left(sign * (kPi / 2 - off), Vector3d::UnitY());
        const AngleAxisd up(double{tests::uniform(random, -3, 3)}, Vector3d::UnitZ());
        rotation = Quaterniond(forward * left * up).cast<float>();
      }
      motion.poses.push_back(pose);
    }
    expect_read_back(character, motion, "lock, " + std::to_string(off) + " rad off");
  }
}

// Bounds the angles' rate of change in a somersault, which passes two gimbal locks, and in a spin
// of two turns.
TEST(BvhWriter, AnglesAreContinuousAcrossFrames) {
  const motion::Physique character = motion::default_character();
  for (const Vector3f& axis : {Vector3f(0, 0, 1), Vector3f(0, 1, 0), Vector3f(1, 0, 0)}) {
    motion::Motion motion;
    for (int k = 0; k <= 144; ++k) {
      motion::Pose pose = motion::rest_pose(character.skeleton);
      const auto angle = static_cast<float>(5 * k * kDegree);
      pose.rotation[Role::pelvis] = Eigen::AngleAxisf(angle, axis);
      motion.poses.push_back(pose);
    }
    const Bvh bvh = parse_bvh(bvh_text(character, motion), "written.bvh");
    const auto width = static_cast<std::size_t>(bvh.channel_count);
    Vector3d turned = Vector3d::Zero();
    for (std::size_t k = 1; k < motion.poses.size(); ++k) {
      for (std::size_t c = 3; c < 6; ++c) {
        const double step = bvh.values[k * width + c] - bvh.values[(k - 1) * width + c];
        EXPECT_LT(std::abs(step), 5.001) << axis.transpose() << " at " << k;
        turned[static_cast<Eigen::Index>(c - 3)] += step;
      }
    }
    EXPECT_NEAR(turned.cwiseAbs().maxCoeff(), 720, 1e-3) << axis.transpose();
  }
}

TEST(BvhWriter, RestFigureIsTheTPoseInCentimetresWithEndsAtItsTips) {
  const motion::Physique character = motion::default_character();
  const motion::Skeleton& skeleton = character.skeleton;
  motion::Motion motion;
  motion.poses.push_back(motion::rest_pose(skeleton));
  const Bvh bvh = parse_bvh(bvh_text(character, motion), "written.bvh");
  const motion::JointFrames rest = forward_kinematics(skeleton, motion.poses.front());
  const BvhFrame figure = rest_frame(bvh);
  int ends = 0;
  for (const Role role : kRoles) {
    const std::size_t joint = joint_named(bvh, role);
    const Vector3f from_pelvis = rest.position[role] - rest.position[Role::pelvis];
    EXPECT_LT((from_file() * figure.position[joint] / 100 - from_pelvis.cast<double>()).norm(),
              1e-6);
    for (const Vector3d& end : bvh.joints[joint].end_sites) {
      EXPECT_LT((from_file() * end / 100 - skeleton.tip[role].cast<double>()).norm(), 1e-6);
      ++ends;
    }
  }
  EXPECT_EQ(ends, 5);  // head, hands, toes
  EXPECT_TRUE(bvh.joints.front().offset.isZero());
}

TEST(BvhWriter, ImportKnowsEveryRoleAndTheUnitsAndGivesTheSameMotion) {
  const ClipLibrary library = scenes::synthetic_library();
  const motion::Skeleton& skeleton = library.character.skeleton;
  const tests::TemporaryFolder folder;
  for (const std::string name : {"raise_hands", "turn_shoulder", "turn_shoulder_mirrored"}) {
    const auto clip = std::find_if(library.clips.begin(), library.clips.end(),
                                   [&](const motion::Clip& each) { return each.name == name; });
    ASSERT_NE(clip, library.clips.end());
    const std::string path = folder / (name + ".bvh");
    write_bvh(path, library.character, clip->motion);

    const SourceReport report = inspect_source(path);
    EXPECT_EQ(report.unit, LengthUnit::centimetre);
    EXPECT_EQ(report.up, UpAxis::y);
    for (const Role role : kRoles) EXPECT_EQ(report.joint_name[role], motion::name_of(role));

    const ClipLibrary imported = import_library({path}, std::nullopt).library;
    ASSERT_EQ(imported.clips.size(), 1U);
    const motion::Motion& found = imported.clips.front().motion;
    ASSERT_EQ(found.poses.size(), clip->motion.poses.size());
    double most_m = 0;
    for (std::size_t k = 0; k < found.poses.size(); ++k) {
      // The import puts the pelvis of the first pose above the origin.
      Vector3f shift = -clip->motion.poses.front().root_position;
      shift.z() = 0;
      const motion::Pose pose = motion::placed(clip->motion.poses[k], 0, shift);
      const motion::JointFrames expected = forward_kinematics(skeleton, pose);
      const motion::JointFrames actual =
          forward_kinematics(imported.character.skeleton, found.poses[k]);
      for (const Role role : kRoles) {
        most_m = std::max(most_m, double{(expected.position[role] - actual.position[role]).norm()});
      }
    }
    EXPECT_LT(most_m, 0.005) << name;
    std::printf("%s: imported to %.2f mm\n", name.c_str(), 1e3 * most_m);
  }
}

TEST(BvhWriter, SameInputGivesTheSameTextInMemoryAndInTheFile) {
  const ClipLibrary library = scenes::synthetic_library();
  const std::string text = bvh_text(library.character, library.clips[1].motion);
  EXPECT_EQ(text, bvh_text(library.character, library.clips[1].motion));
  const tests::TemporaryFolder folder;
  write_bvh(folder / "motion.bvh", library.character, library.clips[1].motion);
  EXPECT_EQ(read_file(folder / "motion.bvh"), text);
}

TEST(BvhWriter, WritesNoNegativeZero) {
  const motion::Physique character = motion::default_character();
  motion::Motion motion;
  motion.poses.push_back(motion::rest_pose(character.skeleton));
  motion.poses[0].root_position.x() = -1e-9F;
  motion.poses[0].rotation[Role::neck] = Eigen::AngleAxisf(-1e-9F, Vector3f::UnitY());
  EXPECT_EQ(bvh_text(character, motion).find("-0.000000"), std::string::npos);
}

TEST(BvhWriter, RefusesWhatItCannotWriteAndLeavesNoFile) {
  const motion::Physique character = motion::default_character();
  const tests::TemporaryFolder folder;
  const auto refusal = [&](const motion::Physique& who, const motion::Motion& what) {
    return error_of([&] { write_bvh(folder / "refused.bvh", who, what); });
  };
  motion::Motion motion;
  EXPECT_THAT(refusal(character, motion), HasSubstr("no poses"));
  motion.poses.push_back(motion::rest_pose(character.skeleton));
  motion.rate_hz = 0;
  EXPECT_THAT(refusal(character, motion), HasSubstr("rate"));
  motion.rate_hz = 60;
  motion.poses[0].rotation[Role::neck].x() = std::numeric_limits<float>::infinity();
  EXPECT_THAT(refusal(character, motion), HasSubstr("pose 0 of the motion"));
  motion.poses[0] = motion::rest_pose(character.skeleton);
  motion::Physique nobody = character;
  nobody.mass_kg = 0;
  EXPECT_THAT(refusal(nobody, motion), HasSubstr("mass"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(EulerAngles, ReproduceTheRotationNearTheGivenAngles) {
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    Vector3d made = tests::random_vector(random, 9).cast<double>();
    if (i % 2 == 0) made[1] = kPi / 2 * std::round(made[1] / (kPi / 2)) + 1e-7 * made[0];
    const auto turn = [](const Vector3d& angles) {
      return Quaterniond(AngleAxisd(angles[0], Vector3d::UnitZ()) *
                         AngleAxisd(angles[1], Vector3d::UnitX()) *
                         AngleAxisd(angles[2], Vector3d::UnitY()));
    };
    const Vector3d near = made + tests::random_vector(random, 0.1F).cast<double>();
    const Vector3d found = euler_zxy(turn(made), near);
    EXPECT_LT(turn(found).angularDistance(turn(made)), 2e-6);
    if (std::abs(std::cos(made[1])) > 0.2) {
      EXPECT_LT((found - made).cwiseAbs().maxCoeff(), 1e-6) << made.transpose();
    }
  }
}

// Rounding errors of floats must not rotate the two coinciding axes against each other.
TEST(EulerAngles, KeepTheFirstAngleAtGimbalLock) {
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d near(double{tests::uniform(random, -9, 9)}, i % 2 == 0 ? kPi / 2 : -kPi / 2,
                        double{tests::uniform(random, -9, 9)});
    const Quaterniond exact = AngleAxisd(near[0], Vector3d::UnitZ()) *
                              AngleAxisd(near[1], Vector3d::UnitX()) *
                              AngleAxisd(near[2], Vector3d::UnitY());
    const Quaterniond noisy = exact.cast<float>().normalized().cast<double>().normalized();
    EXPECT_LT((euler_zxy(noisy, near) - near).cwiseAbs().maxCoeff(), 2e-6);
  }
}

}  // namespace
}  // namespace flinch::database
