// SPDX-License-Identifier: MIT
// Tests with recorded files, where there are any: FLINCH_MOCAP_DIR.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "database/import/bvh.h"
#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoMocap = "no motion capture beside the sources";

struct Counted {
  int joints = 0;
  int frames = 0;
  std::vector<double> values;
};

/// Counts and values read in the simplest way: words between blanks, numbers by strtod.
Counted counted(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> words;
  for (std::string word; file >> word;) words.push_back(word);
  Counted counted;
  std::size_t i = 0;
  for (; i < words.size() && words[i] != "Time:"; ++i) {
    if (words[i] == "ROOT" || words[i] == "JOINT") ++counted.joints;
    if (words[i] == "Frames:") counted.frames = std::atoi(words[i + 1].c_str());
  }
  for (i += 2; i < words.size(); ++i) {
    counted.values.push_back(std::strtod(words[i].c_str(), nullptr));
  }
  return counted;
}

TEST(BvhFiles, EveryRecordingMatchesASimpleCount) {
  if (!fs::exists(FLINCH_MOCAP_DIR)) GTEST_SKIP() << kNoMocap;
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(FLINCH_MOCAP_DIR)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".bvh" || path.parent_path().filename() == "odd") continue;
    SCOPED_TRACE(path);
    const Bvh bvh = read_bvh(path.string());
    const Counted expected = counted(path);
    EXPECT_EQ(bvh.joints.size(), static_cast<std::size_t>(expected.joints));
    EXPECT_EQ(bvh.frame_count, expected.frames);
    EXPECT_TRUE(bvh.values == expected.values);
    EXPECT_GT(bvh.frame_time_s, 0);
    ++files;
  }
  EXPECT_GT(files, 0);
}

/// A row of the table in odd/README.md: a valid file's content, or the words with which it is
/// rejected.
struct OddFile {
  const char* name;
  int joints;
  int frames;
  const char* refusal = nullptr;
};

constexpr OddFile kOddFiles[] = {
    {"blank_lines_frame_over_lines.bvh", 18, 2},
    {"crlf_tabs_header.bvh", 19, 455},
    {"deepmimic_skeleton_run.bvh", 16, 25},
    {"four_rotation_orders.bvh", 24, 75},
    {"full_precision_frame_time.bvh", 2, 3},
    {"leaf_without_endsite_4_joints.bvh", 4, 120},
    {"makehuman_one_frame_dotted_names.bvh", 163, 1},
    {"mixamorig_names_zyx.bvh", 55, 69},
    {"more_rows_than_declared.bvh", 0, 0, ".bvh:38: frame 1 begins with 24 values"},
    {"no_root_must_be_rejected.bvh", 0, 0, ".bvh:1: is not BVH: expected HIERARCHY, found `End`"},
    {"rotation_before_position.bvh", 4, 4},
    {"sci_notation_positions_crlf.bvh", 75, 2},
    {"sfu_walk_xyz_no_endsite.bvh", 25, 270},
    {"single_joint.bvh", 1, 360},
};

TEST(BvhFiles, UnusualFilesLoadOrFailAsExpected) {
  const fs::path folder = fs::path(FLINCH_MOCAP_DIR) / "odd";
  if (!fs::exists(folder)) GTEST_SKIP() << kNoMocap;
  for (const OddFile& odd : kOddFiles) {
    SCOPED_TRACE(odd.name);
    Bvh bvh;
    const std::string error =
        tests::error_of([&] { bvh = read_bvh((folder / odd.name).string()); });
    if (odd.refusal != nullptr) {
      EXPECT_THAT(error, testing::HasSubstr(odd.refusal));
      continue;
    }
    EXPECT_EQ(error, "");
    EXPECT_EQ(bvh.joints.size(), static_cast<std::size_t>(odd.joints));
    EXPECT_EQ(bvh.frame_count, odd.frames);
    EXPECT_TRUE(bvh.values == counted(folder / odd.name).values);
  }
  const auto files = std::count_if(
      fs::directory_iterator(folder), fs::directory_iterator{},
      [](const fs::directory_entry& entry) { return entry.path().extension() == ".bvh"; });
  EXPECT_EQ(files, std::ssize(kOddFiles)) << "a file without a row in the table above";
}

}  // namespace
}  // namespace flinch::database
