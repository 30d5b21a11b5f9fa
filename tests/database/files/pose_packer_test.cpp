// SPDX-License-Identifier: MIT
#include "database/files/pose_packer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "database/author/authored_library.h"
#include "database/library/packed_poses.h"
#include "motion/default_character.h"
#include "motion/mirror.h"
#include "tests/database/files/unpacked_slowly.h"
#include "tests/motion/random_motion.h"

namespace flinch::database {
namespace {

using motion::Motion;
using motion::Pose;
using motion::Role;

/// With every bit, so that 0 and -0 differ.
std::vector<std::uint32_t> bits_of(const std::vector<Pose>& poses) {
  std::vector<std::uint32_t> bits;
  for (const Pose& pose : poses) {
    for (const float x : pose.root_position) bits.push_back(std::bit_cast<std::uint32_t>(x));
    for (const Eigen::Quaternionf& rotation : pose.rotation)
      for (const float x : rotation.coeffs()) bits.push_back(std::bit_cast<std::uint32_t>(x));
  }
  return bits;
}

Motion random_motion(unsigned seed) {
  std::mt19937 random(seed);
  Motion motion;
  for (int k = 0; k < 30; ++k) motion.poses.push_back(tests::random_pose(random));
  return motion;
}

Motion snapped(Motion motion) {
  snap(motion);
  return motion;
}

Motion mirrored(Motion motion) {
  for (Pose& pose : motion.poses) pose = motion::mirrored(pose);
  return motion;
}

/// Every clip of the default library with half a turn more, in steps, so that components change
/// places and signs.
std::vector<Motion> motions() {
  std::vector<Motion> motions;
  for (unsigned seed = 0; seed < 5; ++seed) motions.push_back(random_motion(seed));
  for (const motion::Clip& clip : authored_library_off_grid(motion::default_character()).clips)
    motions.push_back(clip.motion);
  Motion turning = motions.back();
  for (std::size_t k = 0; k < turning.poses.size(); ++k) {
    const float angle = 0.1F * static_cast<float>(k);
    for (Eigen::Quaternionf& rotation : turning.poses[k].rotation)
      rotation = rotation * Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitY());
  }
  motions.push_back(std::move(turning));
  return motions;
}

TEST(Snap, ChangesNoBitOfWhatIsOnTheGrid) {
  for (const Motion& motion : motions()) {
    const Motion once = snapped(motion);
    ASSERT_NE(bits_of(once.poses), bits_of(motion.poses));
    EXPECT_EQ(bits_of(snapped(once).poses), bits_of(once.poses));
  }
}

TEST(Snap, KeepsSignsAndUnitRotationsNearby) {
  for (const Motion& motion : motions()) {
    const Motion there = snapped(motion);
    for (std::size_t k = 0; k < motion.poses.size(); ++k) {
      for (const Role role : motion::kRoles) {
        const Eigen::Vector4f from = motion.poses[k].rotation[role].coeffs();
        const Eigen::Vector4f to = there.poses[k].rotation[role].coeffs();
        EXPECT_NEAR(to.cast<double>().norm(), 1, 1e-7);
        // Half a step of three components, and up to three times as much of the fourth.
        EXPECT_LT((to - from).norm(), 4 * std::exp2(-15.0));
      }
    }
  }
}

TEST(Snap, MirrorImagesStayMirrorImages) {
  for (const Motion& motion : motions()) {
    const Motion one = snapped(mirrored(motion));
    const Motion other = mirrored(snapped(motion));
    EXPECT_EQ(bits_of(one.poses), bits_of(snapped(other).poses));
    for (std::size_t k = 0; k < motion.poses.size(); ++k) {
      EXPECT_EQ(one.poses[k].root_position, other.poses[k].root_position);
      for (const Role role : motion::kRoles)
        EXPECT_EQ(one.poses[k].rotation[role].coeffs(), other.poses[k].rotation[role].coeffs());
    }
  }
}

TEST(Snap, MovesNoJointOfTheDefaultClipsByMoreThanTheStatedBounds) {
  constexpr float kMaxJoint_m = 0.15e-3F;
  constexpr float kMaxFoot_m = 0.1e-3F;
  const ClipLibrary before = authored_library_off_grid(motion::default_character());
  const ClipLibrary after = authored_library(motion::default_character());
  const motion::Skeleton& skeleton = before.character.skeleton;
  ASSERT_EQ(before.clips.size(), after.clips.size());
  int poses = 0;
  float farthest = 0;
  for (std::size_t c = 0; c < before.clips.size(); ++c) {
    for (std::size_t k = 0; k < before.clips[c].motion.poses.size(); ++k, ++poses) {
      const auto a = forward_kinematics(skeleton, before.clips[c].motion.poses[k]);
      const auto b = forward_kinematics(skeleton, after.clips[c].motion.poses[k]);
      const auto tip = [&](const motion::JointFrames& frames, Role role) {
        return Eigen::Vector3f(frames.position[role] +
                               frames.orientation[role] * skeleton.tip[role]);
      };
      for (const Role role : motion::kRoles) {
        const bool is_foot = role == Role::left_foot || role == Role::right_foot ||
                             role == Role::left_toes || role == Role::right_toes;
        const float bound = is_foot ? kMaxFoot_m : kMaxJoint_m;
        const float moved = std::max((a.position[role] - b.position[role]).norm(),
                                     (tip(a, role) - tip(b, role)).norm());
        ASSERT_LE(moved, bound) << before.clips[c].name << ", " << name_of(role);
        farthest = std::max(farthest, moved);
      }
    }
  }
  EXPECT_GT(poses, 10'000);
  EXPECT_GT(farthest, 0.01e-3F) << "nothing was moved";
}

TEST(PackedPoses, GiveBackEveryBitAndTheSlowTwinAgrees) {
  bool some_vary = false;
  for (const Motion& motion : motions()) {
    const std::vector<Pose> poses = snapped(motion).poses;
    const auto packed = pack_poses(poses);
    ASSERT_TRUE(packed);
    std::vector<Pose> unpacked;
    ASSERT_TRUE(unpack_poses(*packed, unpacked));
    ASSERT_EQ(bits_of(unpacked), bits_of(poses));
    EXPECT_EQ(bits_of(tests::unpacked_slowly(*packed)), bits_of(poses));
    some_vary |= (*packed)[4 + kTrackHeaderBytes * kRootTracks] == kDerivedPerPose;
  }
  EXPECT_TRUE(some_vary) << "no pelvis has a derived component that differs from pose to pose";
}

TEST(PackedPoses, AreNoneOffTheGrid) {
  std::vector<Pose> poses = snapped(random_motion(1)).poses;
  ASSERT_TRUE(pack_poses(poses));
  const auto fails = [&](auto change) {
    std::vector<Pose> changed = poses;
    change(changed[7]);
    return !pack_poses(changed);
  };
  EXPECT_TRUE(fails([](Pose& pose) { pose.root_position.y() += 1e-5F; }));
  EXPECT_TRUE(fails([](Pose& pose) { pose.root_position.y() = -0.0F; }));
  EXPECT_TRUE(fails([](Pose& pose) {
    float& w = pose.rotation[Role::head].w();
    w = std::nextafter(w, 2.0F);
  }));
}

TEST(PackedPoses, AreNoneOfNoPose) {
  EXPECT_FALSE(pack_poses({}));
}

TEST(PackedPoses, OfAPoseThatStandsStillTakeNoBits) {
  const std::vector<Pose> poses(1000, snapped(random_motion(2)).poses[0]);
  EXPECT_EQ(pack_poses(poses)->size(), kPackedHeaderBytes + kPaddingBytes);
}

TEST(PackedPoses, AreRefusedIfTheirNumbersDisagree) {
  const std::vector<std::uint8_t> whole = *pack_poses(snapped(random_motion(3)).poses);
  const auto is_read = [](const std::vector<std::uint8_t>& bytes) {
    std::vector<Pose> poses;
    return unpack_poses(bytes, poses);
  };
  EXPECT_TRUE(is_read(whole));
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, kPackedHeaderBytes,
                                 kPackedHeaderBytes + kPaddingBytes, whole.size() - 1})
    EXPECT_FALSE(is_read({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}));
  std::vector<std::uint8_t> longer = whole;
  longer.push_back(0);
  EXPECT_FALSE(is_read(longer));
  const auto with = [&](std::size_t place, std::uint8_t byte) {
    std::vector<std::uint8_t> changed = whole;
    changed[place] = byte;
    return is_read(changed);
  };
  EXPECT_FALSE(with(0, 0)) << "no pose";
  EXPECT_FALSE(with(0, static_cast<std::uint8_t>(whole[0] + 1))) << "one pose more";
  EXPECT_FALSE(with(3, 0xFF)) << "four billion poses";
  const std::size_t shape = 4 + kTrackHeaderBytes - 1;
  EXPECT_FALSE(with(shape, static_cast<std::uint8_t>(whole[shape] ^ 1))) << "another width";
  EXPECT_FALSE(with(shape, static_cast<std::uint8_t>((whole[shape] & 31) | 3 << kWidthBits)))
      << "an unknown order";
  EXPECT_FALSE(with(4 + kTrackHeaderBytes * kRootTracks, 9)) << "an unknown derived component";
}

}  // namespace
}  // namespace flinch::database
