// SPDX-License-Identifier: MIT
#include "database/files/file_kind.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/database/import/bvh_samples.h"

namespace flinch::database {
namespace {

using tests::kPlainBvh;
using tests::replaced;

TEST(FileKind, BvhIsKnownWhateverComesBeforeItsFirstWord) {
  const std::string plain = kPlainBvh;
  const std::vector<std::string> openings{plain,
                                          "\n\r\n \t\n" + plain,
                                          "\xEF\xBB\xBF" + replaced(plain, "\n", "\r\n"),
                                          "# by a tool\n\n# 2\n" + plain,
                                          "hierarchy\nroot",
                                          std::string(60000, '\n') + plain,
                                          plain + std::string(9, '\0')};
  for (const std::string& text : openings) {
    EXPECT_EQ(file_kind_of(text), FileKind::bvh) << text.substr(0, 40);
  }
}

TEST(FileKind, FbxAndGltfAreKnownAsBinaryAndAsText) {
  EXPECT_EQ(file_kind_of("; FBX 7.4.0 project file\n"), FileKind::fbx);
  EXPECT_EQ(file_kind_of("Kaydara FBX Binary  "), FileKind::fbx);
  EXPECT_EQ(file_kind_of("glTF\x02"), FileKind::gltf);
  EXPECT_EQ(file_kind_of("\n{ \"nodes\": [], \"asset\": {}}"), FileKind::gltf);
  EXPECT_EQ(file_kind_of("{ \"nodes\": []}"), FileKind::text);
}

TEST(FileKind, Utf16IsKnownWithAndWithoutItsMark) {
  const auto utf16 = [](bool is_big_endian, const std::string& text) {
    std::string bytes;
    for (const char c : text) bytes += is_big_endian ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
  };
  for (const std::string text : {"HIERARCHY\n", "[[idle]]\n"}) {
    for (const bool is_big_endian : {false, true}) {
      const std::string bytes = utf16(is_big_endian, text);
      const std::string mark = is_big_endian ? "\xFE\xFF" : "\xFF\xFE";
      EXPECT_EQ(file_kind_of(bytes), FileKind::utf16);
      EXPECT_EQ(file_kind_of(mark + bytes), FileKind::utf16);
    }
  }
  EXPECT_EQ(file_kind_of(std::string(8, '\0')), FileKind::unknown);
  EXPECT_EQ(file_kind_of("\xEF\xBB\xBF[[idle]]\n"), FileKind::text);
}

TEST(FileKind, TextThatIsNotBvhIsText) {
  for (const std::string text :
       {"Dear Sir,\n", "\n\n", "# HIERARCHY\n", "HIERARCHYS", "MOTION\n"}) {
    EXPECT_EQ(file_kind_of(text), FileKind::text) << text;
  }
  EXPECT_EQ(file_kind_of(""), FileKind::empty);
}

}  // namespace
}  // namespace flinch::database
