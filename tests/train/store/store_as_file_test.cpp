// SPDX-License-Identifier: MIT
// The store as a file: what is left beside it, links, permissions and full disks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "tests/scenes/error_of.h"
#include "tests/train/store/made_up_store.h"
#include "train/store/sqlite.h"

namespace flinch::train {
namespace {

using testing::HasSubstr;
using tests::error_of;

TEST(Store, WhatAKilledWriterLeavesBesideAFinishedStoreIsRemoved) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const std::string path = folder / "a";
  write_store(path, header, 20);
  const std::string whole = read_file(path);
  // Killed after the store got its name: its sealed twin, a copy and an empty journal are left.
  for (const char* left : {".partial", ".partial-copy", ".partial-copy-journal"})
    folder.write(std::string("a") + left, whole);
  folder.write("a.partial-journal", "");
  StoreWriter::remove_left_overs(path);
  EXPECT_TRUE(read_file(path) == whole);
  // Killed before the journal was removed.
  folder.write("a.partial-journal", std::string(512, '\0'));
  StoreWriter::remove_left_overs(path);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Store, APartialFileIsKeptWhileItHoldsMoreOrIsBeingWritten) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const std::string path = folder / "a";
  write_store(path, header, 20);
  {
    StoreWriter writer(path, header, {0, 40});
    StoreWriter::remove_left_overs(path);
    writer.append(made_up_observations(header, 20, 30));
  }
  StoreWriter::remove_left_overs(path);
  EXPECT_EQ(StoreWriter(path, header, {0, 40}).count(), 30U);
}

TEST(Store, IsWrittenWhereALinkLeadsWithThePermissionsOfWhatItReplaces) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  std::filesystem::create_directory(folder / "elsewhere");
  std::filesystem::create_symlink("elsewhere/a", folder / "link");
  write_store(folder / "link", header, 10);
  const auto owner_only = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(folder / "elsewhere/a", owner_only);
  {
    const StoreWriter writer(folder / "link", header, {0, 20});
    EXPECT_EQ(std::filesystem::status(writer.partial_path()).permissions(), owner_only);
  }
  write_store(folder / "link", header, 20);
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  const auto written = std::filesystem::symlink_status(folder / "elsewhere/a");
  EXPECT_EQ(written.type(), std::filesystem::file_type::regular);
  EXPECT_EQ(written.permissions(), owner_only);
  EXPECT_EQ(summarise_store(folder / "link").observation_count, 20U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "elsewhere"), {}), 1);
}

TEST(Store, IsNeverWrittenThroughAPartialFileThatIsALink) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  folder.write("precious", "");
  for (const char* link : {"a.partial", "b.partial-copy"})
    std::filesystem::create_symlink("precious", folder / link);
  EXPECT_THAT(error_of([&] { write_store(folder / "a", header, 10); }),
              HasSubstr("a.partial: is a link"));
  EXPECT_THAT(error_of([&] { write_store(folder / "b", header, 10); }),
              HasSubstr("b.partial-copy: is in the way"));
  EXPECT_EQ(read_file(folder / "precious"), "");
  EXPECT_FALSE(std::filesystem::exists(folder / "b"));
}

TEST(Store, AFileOfAnotherKindIsReplacedOnlyIfForced) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const std::string path = folder.write("letter", "Dear Sir,\n");
  EXPECT_THAT(error_of([&] { write_store(path, header, 10); }), HasSubstr("not a store"));
  {
    StoreWriter writer(path, header, {0, 10}, database::Overwrite::force);
    writer.append(made_up_observations(header, 0, 10));
    EXPECT_EQ(read_file(path), "Dear Sir,\n");
    writer.finish();
  }
  EXPECT_EQ(summarise_store(path).observation_count, 10U);
}

TEST(Store, NamesThatSqliteTakesForOtherThingsAreFiles) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  for (const char* name : {":memory:", "file:a?mode=memory", "file::memory:"}) {
    write_store(name, header, 10);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / name));
    EXPECT_EQ(read_store(name).observations.size(), 10U);
  }
  std::filesystem::current_path(before);
}

TEST(Store, LosesNothingWhenTheDiskFillsWhileFinishing) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  write_store(folder / "whole", header, 64);
  const std::string path = folder / "full";
  {
    StoreWriter writer(path, header, {0, 64});
    writer.append(made_up_observations(header, 0, 64));
    signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = std::filesystem::file_size(writer.partial_path()) / 2;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string message = error_of([&] { writer.finish(); });
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_THAT(message, HasSubstr("make room"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path + ".partial-copy"));
  EXPECT_EQ(StoreWriter(path, header, {0, 64}).count(), 64U);
  write_store(path, header, 64);
  EXPECT_TRUE(read_file(path) == read_file(folder / "whole"));
}

TEST(Store, ReportsAFullDiskAndKeepsCommittedScenarios) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  write_store(folder / "whole", header, 160);
  const std::string path = folder / "full";
  {
    StoreWriter writer(path, header, kWanted);
    writer.append(made_up_observations(header, 0, 16));
    // Files of this process cannot grow any more, which looks like a full disk to the writer.
    signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = std::filesystem::file_size(writer.partial_path());
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string message =
        error_of([&] { writer.append(made_up_observations(header, 16, 160)); });
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_THAT(message, HasSubstr("full.partial: "));
    EXPECT_THAT(message, HasSubstr("make room"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(StoreWriter(path, header, kWanted).count(), 16U);
  write_store(path, header, 160);
  EXPECT_TRUE(read_file(path) == read_file(folder / "whole"));
}

TEST(Sqlite, ReportsAFullDatabaseAsAFullDisk) {
  const TemporaryFolder folder;
  Database database(folder / "small", Database::Mode::create);
  database.execute("CREATE TABLE t(x)");
  database.execute("PRAGMA max_page_count = 3");
  const std::string message = error_of([&] {
    Transaction transaction(database);
    database.execute("INSERT INTO t VALUES(zeroblob(100000))");
    transaction.commit();
  });
  EXPECT_THAT(message, HasSubstr("the disk is full"));
}

}  // namespace
}  // namespace flinch::train
