// SPDX-License-Identifier: MIT
#include "database/files/file_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Simulates a full disk for this process: no file may grow beyond `bytes`.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

std::vector<std::string> files_in(const tests::TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

TEST(FileIo, BytesRoundTrip) {
  const tests::TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 200000; ++i) bytes += static_cast<char>(i * 7);
  for (const std::string& content : {bytes, std::string(), std::string("\0\r\n", 3)}) {
    write_file_atomically(folder / "file", content);
    EXPECT_TRUE(read_file(folder / "file") == content);
  }
  EXPECT_THAT(files_in(folder), testing::ElementsAre("file"));
}

TEST(FileIo, ADiskThatFillsUpLeavesTheOldFileAndNothingElse) {
  const tests::TemporaryFolder folder;
  write_file_atomically(folder / "file", "old");
  std::string error;
  {
    const FileSizeLimit full(100000);
    error =
        tests::error_of([&] { write_file_atomically(folder / "file", std::string(1000000, 'x')); });
  }
  EXPECT_THAT(error, AllOf(StartsWith(folder / "file: cannot be written: "),
                           HasSubstr("File too large"), HasSubstr("elsewhere")));
  EXPECT_EQ(read_file(folder / "file"), "old");
  EXPECT_THAT(files_in(folder), testing::ElementsAre("file"));
}

TEST(FileIo, NamesUnwritablePaths) {
  const tests::TemporaryFolder folder;
  EXPECT_THAT(tests::error_of([&] { write_file_atomically(folder / "no/file", "x"); }),
              AllOf(StartsWith(folder / "no/file: cannot be written: No such file"),
                    HasSubstr("make its folder first")));
  EXPECT_THAT(tests::error_of([&] { write_file_atomically(folder.path(), "x"); }),
              StartsWith(folder.path() + ": is a folder"));
  EXPECT_THAT(files_in(folder), testing::IsEmpty());
}

TEST(FileIo, NamesUnreadableFiles) {
  const tests::TemporaryFolder folder;
  EXPECT_THAT(tests::error_of([&] { read_file(folder / "none"); }),
              AllOf(StartsWith(folder / "none: cannot be read: No such file")));
  EXPECT_THAT(tests::error_of([&] { read_file(folder.path()); }), HasSubstr("is a folder"));
}

}  // namespace
}  // namespace flinch::database
