// SPDX-License-Identifier: MIT
#include "database/library/input_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

LoadStatus status_of(const std::string& path) {
  std::string text = "kept";
  std::vector<std::byte> bytes(3);
  std::string start = "kept";
  const LoadStatus status = read_bytes(path, text);
  EXPECT_EQ(read_bytes(path, bytes), status);
  if (status != LoadStatus::ok) {
    EXPECT_EQ(text, "kept");
    EXPECT_EQ(bytes.size(), 3U);
  }
  if (status != LoadStatus::too_large) {
    EXPECT_EQ(read_first_bytes(path, 1, start), status);
  }
  return status;
}

TEST(InputFile, ReadsWholeFilesAndBeginnings) {
  const tests::TemporaryFolder folder;
  std::string content;
  for (int i = 0; i < 300000; ++i) content += static_cast<char>(i * 7);
  for (const std::string& text : {content, std::string(), std::string("\0\r\n", 3)}) {
    const std::string path = folder.write("file", text);
    std::string read;
    EXPECT_EQ(read_bytes(path, read), LoadStatus::ok);
    EXPECT_TRUE(read == text);
    EXPECT_EQ(read_first_bytes(path, 10, read), LoadStatus::ok);
    EXPECT_TRUE(read == text.substr(0, 10));
  }
}

TEST(InputFile, RefusesWhatIsNoRegularFileAtOnce) {
  const tests::TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(status_of(folder / "fifo"), LoadStatus::not_a_file);  // without a writer
  EXPECT_EQ(status_of("/dev/zero"), LoadStatus::not_a_file);
  EXPECT_EQ(status_of("/dev/null"), LoadStatus::not_a_file);
  EXPECT_EQ(status_of(folder.path()), LoadStatus::not_a_file);
  EXPECT_EQ(status_of(folder / "none"), LoadStatus::cannot_open);
  std::filesystem::create_symlink("/dev/zero", folder / "link");
  EXPECT_EQ(status_of(folder / "link"), LoadStatus::not_a_file);
}

TEST(InputFile, RefusesAFileThatIsTooLargeByWhatItClaims) {
  const tests::TemporaryFolder folder;
  // Holes: no disk is used, whatever the size.
  const std::string path = folder.write("huge", "FLINCHL");
  ASSERT_EQ(::truncate(path.c_str(), static_cast<off_t>(kMaxFileSize) + 1), 0);
  EXPECT_EQ(status_of(path), LoadStatus::too_large);
  if (::truncate(path.c_str(), off_t{1} << 43) == 0) {  // as large as the file system allows
    EXPECT_EQ(status_of(path), LoadStatus::too_large);
  }
  std::string start;
  EXPECT_EQ(read_first_bytes(path, 7, start), LoadStatus::ok);
  EXPECT_EQ(start, "FLINCHL");
}

}  // namespace
}  // namespace flinch::database
