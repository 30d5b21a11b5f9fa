// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "database/import/bvh.h"
#include "tests/database/import/bvh_samples.h"
#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using tests::kPlainBvh;

struct Counts {
  int read = 0;
  int refused = 0;
};

/// Any result other than a valid Bvh or an Error fails the test or trips the sanitizers.
void try_to_parse(const std::string& text, Counts& counts) {
  Bvh bvh;
  const std::string error = tests::error_of([&] { bvh = parse_bvh(text, "mutant"); });
  if (!error.empty()) {
    ++counts.refused;
    ASSERT_TRUE(error.starts_with("mutant: ") || error.starts_with("mutant:")) << error;
    return;
  }
  ++counts.read;
  ASSERT_EQ(bvh.values.size(), static_cast<std::size_t>(bvh.frame_count) *
                                   static_cast<std::size_t>(bvh.channel_count));
  for (int frame = 0; frame < bvh.frame_count; ++frame) {
    ASSERT_EQ(forward_kinematics(bvh, frame).position.size(), bvh.joints.size());
  }
}

TEST(BvhMutations, ATruncatedFileIsRefusedUnlessOnlyTheLastNumberLostDigits) {
  Counts counts;
  const std::string text = kPlainBvh;
  const std::size_t last_number = text.rfind("-12.5");
  for (std::size_t size = 0; size < text.size(); ++size) {
    const int read_before = counts.read;
    try_to_parse(text.substr(0, size), counts);
    if (size <= last_number) {
      EXPECT_EQ(counts.read, read_before) << size;
    }
  }
  EXPECT_EQ(counts.read, 4);  // -1, -12, -12. and -12.5 without its line end
}

std::string mutated(std::string text, std::mt19937& random) {
  constexpr std::array<const char*, 16> kScraps{"{",          "}",
                                                "\n",         "\r",
                                                " ",          "-",
                                                ".",          "e",
                                                "9",          "nan",
                                                "JOINT x",    "End Site",
                                                "CHANNELS 3", "OFFSET 0 0 0",
                                                "MOTION",     "Frames: 99999999"};
  const auto at = [&] { return random() % text.size(); };
  const auto edits = 1 + random() % 3;
  for (unsigned edit = 0; edit < edits; ++edit) {
    const auto kind = random() % 4;
    if (kind == 0) {
      text[at()] = static_cast<char>(random() % 256);
    } else if (kind == 1) {
      text.erase(at(), 1 + random() % 20);
    } else if (kind == 2) {
      text.insert(at(), kScraps[random() % kScraps.size()]);
    } else {
      text.insert(at(), text.substr(at(), random() % 60));
    }
  }
  return text;
}

TEST(BvhMutations, RandomEditsNeverCrashTheReader) {
  std::mt19937 random(20);
  Counts counts;
  for (int i = 0; i < 20000; ++i) try_to_parse(mutated(kPlainBvh, random), counts);
  EXPECT_GT(counts.read, 300);
  EXPECT_GT(counts.refused, 10000);
}

}  // namespace
}  // namespace flinch::database
