// SPDX-License-Identifier: MIT
#include "database/files/partial_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "database/files/file_io.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

mode_t mode_of(const std::string& path) {
  struct stat about {};
  ::stat(path.c_str(), &about);
  return about.st_mode & 07777;
}

TEST(PartialFile, AFileThatIsReplacedKeepsItsPermissions) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.write("file", "old");
  for (const mode_t mode : {0600, 0640, 0444, 0777}) {
    ::chmod(path.c_str(), mode);
    write_file_atomically(path, "new");
    EXPECT_EQ(mode_of(path), mode);
  }
}

TEST(PartialFile, OthersCannotReadWhatReplacesAPrivateFile) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.write("file", "old");
  ::chmod(path.c_str(), 0600);
  const PartialFile file(path + ".partial", path);
  EXPECT_EQ(mode_of(path + ".partial"), 0600U);
}

TEST(PartialFile, AnOutputThatIsALinkRemainsOneAndItsTargetIsReplaced) {
  const tests::TemporaryFolder folder;
  fs::create_directory(folder / "elsewhere");
  folder.write("elsewhere/file", "old");
  fs::create_symlink("elsewhere/file", folder / "link");
  fs::create_symlink("link", folder / "second");
  write_file_atomically(folder / "second", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "second"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_FALSE(fs::is_symlink(folder / "elsewhere/file"));
  EXPECT_EQ(read_file(folder / "elsewhere/file"), "new");
  fs::create_symlink("elsewhere/made", folder / "dangling");
  write_file_atomically(folder / "dangling", "made");
  EXPECT_EQ(read_file(folder / "elsewhere/made"), "made");
}

TEST(PartialFile, APartialFileIsNeverWrittenThroughALink) {
  const tests::TemporaryFolder folder;
  const std::string precious = folder.write("precious", "precious");
  fs::create_symlink("precious", folder / "file.partial");
  EXPECT_THAT(tests::error_of([&] { write_file_atomically(folder / "file", "new"); }),
              HasSubstr("file.partial: is in the way"));
  EXPECT_EQ(read_file(precious), "precious");
  EXPECT_TRUE(fs::is_symlink(folder / "file.partial"));
  EXPECT_FALSE(fs::exists(folder / "file"));
}

TEST(PartialFile, WhatAKilledProcessLeftIsRemovedAndAHardLinkToItKept) {
  const tests::TemporaryFolder folder;
  folder.write("file.partial", "half of a");
  fs::create_hard_link(folder / "file.partial", folder / "twin");
  write_file_atomically(folder / "file", "whole");
  EXPECT_EQ(read_file(folder / "file"), "whole");
  EXPECT_EQ(read_file(folder / "twin"), "half of a");
  EXPECT_FALSE(fs::exists(folder / "file.partial"));
}

TEST(PartialFile, TwoWritersDoNotMix) {
  const tests::TemporaryFolder folder;
  const std::string path = folder / "file";
  PartialFile first(path + ".partial", path);
  first.write("fir");
  EXPECT_THAT(tests::error_of([&] { write_file_atomically(path, "second"); }),
              HasSubstr("another process is writing it"));
  first.write("st");
  first.commit();
  EXPECT_EQ(read_file(path), "first");
}

TEST(PartialFile, ADiscardedFileLeavesNothing) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.write("file", "old");
  { PartialFile(path + ".partial", path).write("new"); }
  EXPECT_EQ(read_file(path), "old");
  EXPECT_FALSE(fs::exists(path + ".partial"));
}

TEST(PartialFile, DevicesAndPipesAreNotReplaced) {
  const tests::TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(tests::error_of([&] { write_file_atomically(folder / "pipe", "new"); }),
              HasSubstr("is no regular file"));
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

}  // namespace
}  // namespace flinch::database
