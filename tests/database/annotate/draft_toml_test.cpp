// SPDX-License-Identifier: MIT
#include "database/annotate/draft_toml.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "database/export/bvh_writer.h"
#include "database/import/import.h"
#include "database/import/manifest.h"
#include "motion/error.h"
#include "tests/database/annotate/take_scene.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;
using motion::Pose;
using tests::pulse;
using tests::standing;
using tests::take_of;

class DraftFileTest : public testing::Test {
 protected:
  DraftFileTest() {
    folder_ = fs::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  ~DraftFileTest() override { fs::remove_all(folder_); }

  std::string written(const std::string& name, const Take& take) const {
    const std::string path = (folder_ / name).string();
    write_bvh(path, take.figure.character, take.motion);
    return path;
  }

  fs::path folder_;
};

Take duck_and_shove() {
  return take_of(9, [](double time_s) {
    Pose pose = standing();
    pose.root_position.z() -= 0.45F * pulse(time_s, 1.5, 2.0, 2.6);
    pose.root_position.x() += 0.5F * tests::minimum_jerk(time_s, 5.0, 5.5);
    return pose;
  });
}

TEST_F(DraftFileTest, ImportAcceptsADraftAsItIs) {
  const std::string name = "a \"take\".bvh";
  const std::string path = written(name, duck_and_shove());
  SourceOptions options;
  options.unit = LengthUnit::centimetre;
  options.rest = path;
  options.frames = {.rate_hz = 60.5, .range = FrameRange{3, {}}, .skip_first = true};
  options.roles[motion::Role::head] = read_take(path).source.joint_name[motion::Role::head];
  Draft draft = draft_of(read_take(path, options));
  ASSERT_EQ(draft.clips.size(), 2U);
  draft.clips[0].kind.value = MovementKind::duck;
  draft.clips[1].kind.value = MovementKind::push;
  const std::string manifest_path = (folder_ / "draft.toml").string();
  std::ofstream(manifest_path) << draft_toml(draft, {name, "draft.svg", name}, options);

  const Manifest manifest = read_manifest(manifest_path);
  ASSERT_EQ(manifest.entries.size(), 1 + draft.clips.size());
  EXPECT_EQ(options_for(manifest, name).unit, LengthUnit::centimetre);
  EXPECT_EQ(options_for(manifest, name).roles, options.roles);
  EXPECT_EQ(options_for(manifest, name).rest, name);
  const FrameOptions frames = options_for(manifest, name).frames;
  EXPECT_EQ(frames.rate_hz, options.frames.rate_hz);
  EXPECT_EQ(text_of(frames.range.value()), "3:");
  EXPECT_EQ(frames.skip_first, true);
  const ClipLibrary library = import_library({folder_.string()}, manifest_path).library;
  const auto has = [&](motion::Purpose purpose) {
    return std::any_of(library.clips.begin(), library.clips.end(),
                       [&](const motion::Clip& clip) { return clip.purpose == purpose; });
  };
  EXPECT_TRUE(has(motion::Purpose::idle));
  EXPECT_TRUE(has(motion::Purpose::anticipation));
  EXPECT_TRUE(has(motion::Purpose::push));
}

TEST_F(DraftFileTest, TimesOfTheManifestAreThoseOfTheDraft) {
  const std::string path = written("take.bvh", duck_and_shove());
  const Draft draft = draft_of(read_take(path));
  const std::string manifest_path = (folder_ / "draft.toml").string();
  std::ofstream(manifest_path) << draft_toml(draft, {"take.bvh", "draft.svg", ""}, {});
  const Manifest manifest = read_manifest(manifest_path);
  const ManifestEntry& entry = manifest.entries.at(1);
  ASSERT_TRUE(entry.annotation);
  EXPECT_EQ(entry.name, draft.clips.at(0).name);
  EXPECT_NEAR(entry.annotation->onset_s, draft.clips[0].onset_s, 1e-3);
  EXPECT_NEAR(entry.annotation->peak_s, draft.clips[0].peak_s, 1e-3);
  EXPECT_NEAR(entry.annotation->peak_s, 2.0, 0.05);
}

TEST_F(DraftFileTest, TimesAreThoseOfTheFileWhereOnlySomeFramesAreUsed) {
  const std::string path = written("take.bvh", duck_and_shove());
  SourceOptions options;
  options.frames.range = FrameRange{31, {}};
  const Take take = read_take(path, options);
  EXPECT_NEAR(take.start_s, 0.5, 1e-6);
  EXPECT_NEAR(draft_of(take).clips.at(0).peak_s, 2.0, 0.05);
}

TEST_F(DraftFileTest, TPoseBeforeTheRecordingIsSkipped) {
  Take take = duck_and_shove();
  Pose t_pose = motion::rest_pose(take.figure.skeleton());
  t_pose.root_position.x() += 1;
  take.motion.poses.front() = t_pose;
  const Take read = read_take(written("take.bvh", take));
  EXPECT_NEAR(read.start_s, 2.0 / 60, 1e-6);
}

TEST_F(DraftFileTest, OneFrameIsRefused) {
  Take take = duck_and_shove();
  take.motion.poses.resize(1);
  const std::string path = written("take.bvh", take);
  EXPECT_THROW(read_take(path), Error);
}

}  // namespace
}  // namespace flinch::database
