// SPDX-License-Identifier: MIT
#include "database/files/output_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::StartsWith;

/// Writes libraries into a folder.
class OutputCheck : public testing::Test {
 protected:
  /// Returns the refusal of a library at `path`; empty if it may be written.
  std::string refusal(const std::string& path, const std::vector<std::string>& inputs = {},
                      Overwrite overwrite = Overwrite::refuse) const {
    const Output output{path, FileKind::library, ""};
    return tests::error_of([&] { check_outputs({output}, inputs, overwrite); });
  }
  std::string forced(const std::string& path, const std::vector<std::string>& inputs = {}) const {
    return refusal(path, inputs, Overwrite::force);
  }

  const tests::TemporaryFolder folder_;
};

TEST_F(OutputCheck, NewFilesEmptyFilesAndFilesOfTheSameKindMayBeWritten) {
  EXPECT_EQ(refusal(folder_ / "new"), "");
  EXPECT_EQ(refusal(folder_.write("empty", "")), "");
  EXPECT_EQ(refusal(folder_.write("library", "FLINCHL...")), "");
  fs::create_symlink("library", folder_ / "link");
  fs::create_symlink("nowhere", folder_ / "dangling");
  EXPECT_EQ(refusal(folder_ / "link"), "");
  EXPECT_EQ(refusal(folder_ / "dangling"), "");
}

TEST_F(OutputCheck, FilesOfAnotherKindAreReplacedOnlyIfForced) {
  const std::string selector = folder_.write("selector", "FLINCHS...");
  const std::string letter = folder_.write("letter", "Dear Sir,\n");
  EXPECT_THAT(refusal(selector),
              AllOf(StartsWith(selector + ": is a selector"), HasSubstr("--force")));
  EXPECT_THAT(refusal(letter),
              AllOf(StartsWith(letter + ": is a text file"), HasSubstr("--force")));
  EXPECT_EQ(forced(selector), "");
  EXPECT_EQ(forced(letter), "");
}

TEST_F(OutputCheck, AMarkTellsFlinchsOwnFilesFromOthersOfTheirKind) {
  const std::string path = folder_.write("a.csv", "number,target,x\n");
  const auto refusal_of = [&](std::string_view mark) {
    const Output output{path, FileKind::text, mark};
    return tests::error_of([&] { check_outputs({output}, {}, Overwrite::refuse); });
  };
  EXPECT_EQ(refusal_of("number,target"), "");
  EXPECT_THAT(refusal_of("time,place"), HasSubstr("is a text file, but not made by this command"));
}

TEST_F(OutputCheck, AnInputIsRefusedByWhateverNameEvenIfForced) {
  const std::string input = folder_.write("input", "FLINCHL...");
  fs::create_symlink("input", folder_ / "link");
  fs::create_hard_link(input, folder_ / "twin");
  const std::string roundabout = folder_.path() + "/./input";
  for (const std::string& output : {input, folder_ / "link", folder_ / "twin", roundabout}) {
    EXPECT_THAT(forced(output, {"", folder_ / "missing", input}),
                AllOf(StartsWith(output), HasSubstr("an input of this command")));
  }
  EXPECT_THAT(forced(input, {folder_ / "link"}), HasSubstr("link, an input"));
  EXPECT_EQ(forced(folder_.write("other", "FLINCHL..."), {input}), "");
}

TEST_F(OutputCheck, AnInputFolderStandsForItsMotionCaptureAlone) {
  fs::create_directories(folder_ / "mocap/walks");
  const std::string take = folder_.write("mocap/walks/a.bvh", "HIERARCHY\n");
  const std::string scene = folder_.write("mocap/a.glb", "glTF...");
  const std::string library = folder_.write("mocap/a.flinchlib", "FLINCHL...");
  EXPECT_THAT(forced(take, {folder_ / "mocap"}), HasSubstr("an input"));
  EXPECT_THAT(forced(scene, {folder_ / "mocap"}), HasSubstr("an input"));
  EXPECT_EQ(refusal(library, {folder_ / "mocap"}), "");
}

TEST_F(OutputCheck, OnlyRegularFilesAreReplacedEvenIfForced) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(forced(folder_ / "pipe"), HasSubstr("is a device, pipe or socket"));
  EXPECT_THAT(forced("/dev/null"), HasSubstr("is a device, pipe or socket"));
  EXPECT_THAT(forced(folder_.path()), HasSubstr("is a folder"));
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_THAT(forced(folder_ / "circle"), HasSubstr("too many links"));
}

TEST_F(OutputCheck, PartialFilesThatWouldBeLostAreRefusedToo) {
  const std::string unfinished = folder_.write("a.partial", std::string("SQLite format 3\0", 16));
  EXPECT_THAT(refusal(folder_ / "a"), StartsWith(unfinished + ": is a store"));
  EXPECT_THAT(forced(folder_ / "a", {unfinished}), HasSubstr("an input"));
  EXPECT_EQ(forced(folder_ / "a"), "");
  fs::create_symlink("elsewhere", folder_ / "b.partial");
  EXPECT_THAT(forced(folder_ / "b"), StartsWith(folder_ / "b.partial: is in the way"));
  folder_.write("c.partial", "FLINCHL..");
  EXPECT_EQ(refusal(folder_ / "c"), "");
}

TEST_F(OutputCheck, MissingFoldersAreNamedAtOnce) {
  EXPECT_THAT(refusal(folder_ / "no/where"), HasSubstr("make its folder first"));
  folder_.write("file", "");
  EXPECT_THAT(refusal(folder_ / "file/a"), StartsWith(folder_ / "file/a: cannot be written"));
}

TEST_F(OutputCheck, TwoOutputsAreTwoFiles) {
  fs::create_symlink("a", folder_ / "link");
  const std::vector<Output> twice{{folder_ / "a", FileKind::text, ""},
                                  {folder_ / "link", FileKind::text, ""}};
  EXPECT_THAT(tests::error_of([&] { check_outputs(twice, {}, Overwrite::force); }),
              HasSubstr("two outputs"));
  const auto before = fs::current_path();
  fs::current_path(folder_.path());
  const std::vector<Output> relative{{"new", FileKind::text, ""}, {"./new", FileKind::text, ""}};
  EXPECT_THAT(tests::error_of([&] { check_outputs(relative, {}, Overwrite::force); }),
              HasSubstr("two outputs"));
  fs::current_path(before);
}

TEST_F(OutputCheck, AFolderOfOutputsMayBeMissingButIsNoFile) {
  const std::vector<Output> files{{"report.json", FileKind::text, "{"}};
  const auto refusal_in = [&](const std::string& folder) {
    return tests::error_of([&] { check_output_folder(folder, files, {}, Overwrite::refuse); });
  };
  EXPECT_EQ(refusal_in(folder_ / "new/report"), "");
  EXPECT_EQ(refusal_in(folder_ / "new/report/"), "");
  EXPECT_EQ(refusal_in(folder_.path()), "");
  folder_.write("file", "");
  EXPECT_THAT(refusal_in(folder_ / "file"), HasSubstr("is a file; name a folder"));
  EXPECT_THAT(refusal_in(folder_ / "file/report"), HasSubstr("cannot be written"));
  folder_.write("report.json", "Dear Sir,\n");
  EXPECT_THAT(refusal_in(folder_.path()), StartsWith(folder_ / "report.json: is a text file"));
}

}  // namespace
}  // namespace flinch::database
