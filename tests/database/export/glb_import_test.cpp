// SPDX-License-Identifier: MIT
// What the .glb writer writes, the import reads as it was.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "database/export/bvh_writer.h"
#include "database/export/gltf_writer.h"
#include "database/export/y_up.h"
#include "database/import/import.h"
#include "database/import/source_file.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/synthetic_library.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::Role;

TEST(GlbImport, GivesEveryJointsPlaceAsItWasExported) {
  const ClipLibrary library = scenes::synthetic_library();
  const motion::Skeleton& skeleton = library.character.skeleton;
  const tests::TemporaryFolder folder;
  for (const motion::Clip& clip : library.clips) {
    BallTrack ball;  // moves too, but is no part of the figure
    for (std::size_t k = 0; k < clip.motion.poses.size(); ++k) {
      ball.positions.emplace_back(Eigen::Vector3f(0.1F * static_cast<float>(k), 1, 1));
    }
    const std::string path = folder / (clip.name + ".glb");
    write_glb(path, library.character, clip.motion, ball);
    const Bvh bvh = read_source_file(path);
    ASSERT_EQ(bvh.joints.size(), kRoles.size());
    ASSERT_EQ(static_cast<std::size_t>(bvh.frame_count), clip.motion.poses.size());
    EXPECT_NEAR(bvh.frame_time_s, 1 / static_cast<double>(clip.motion.rate_hz), 1e-6);
    double most_m = 0;
    for (std::size_t k = 0; k < clip.motion.poses.size(); ++k) {
      const BvhFrame found = forward_kinematics(bvh, static_cast<int>(k));
      const motion::JointFrames expected = forward_kinematics(skeleton, clip.motion.poses[k]);
      for (std::size_t i = 0; i < bvh.joints.size(); ++i) {
        const Role role = motion::role_named(bvh.joints[i].name).value();
        const Eigen::Vector3d place = to_y_up(expected.position[role]).cast<double>();
        most_m = std::max(most_m, (found.position[i] - place).norm());
      }
    }
    EXPECT_LT(most_m, 1e-5) << clip.name;
  }
}

// The rest of the import is the same: the clip is the one that the same motion gives as BVH.
TEST(GlbImport, GivesTheSameClipAsABvhFile) {
  const ClipLibrary library = scenes::synthetic_library();
  const tests::TemporaryFolder folder;
  int clips = 0;
  for (const motion::Clip& clip : library.clips) {
    if (clip.name != "raise_hands" && clip.name != "turn_shoulder") continue;
    write_glb(folder / "a.glb", library.character, clip.motion);
    write_bvh(folder / "a.bvh", library.character, clip.motion);
    const SourceReport report = inspect_source(folder / "a.glb");
    for (const Role role : kRoles) EXPECT_EQ(report.joint_name[role], motion::name_of(role));
    EXPECT_TRUE(report.warnings.empty());
    const ClipLibrary from_glb = import_library({folder / "a.glb"}, std::nullopt).library;
    const ClipLibrary from_bvh = import_library({folder / "a.bvh"}, std::nullopt).library;
    const motion::Motion& found = from_glb.clips.at(0).motion;
    const motion::Motion& expected = from_bvh.clips.at(0).motion;
    ASSERT_EQ(found.poses.size(), expected.poses.size());
    double most_m = 0;
    for (std::size_t k = 0; k < found.poses.size(); ++k) {
      const motion::JointFrames one =
          forward_kinematics(from_glb.character.skeleton, found.poses[k]);
      const motion::JointFrames other =
          forward_kinematics(from_bvh.character.skeleton, expected.poses[k]);
      for (const Role role : kRoles) {
        most_m = std::max(most_m, double{(one.position[role] - other.position[role]).norm()});
      }
    }
    EXPECT_LT(most_m, 0.001) << clip.name;
    ++clips;
  }
  EXPECT_EQ(clips, 2);
}

}  // namespace
}  // namespace flinch::database
