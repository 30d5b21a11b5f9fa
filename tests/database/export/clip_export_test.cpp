// SPDX-License-Identifier: MIT
#include "database/export/clip_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/synthetic_library.h"

namespace flinch::database {
namespace {

using testing::ElementsAre;

TEST(ClipExport, NamesAreLowerCaseAndDifferent) {
  ClipLibrary library = scenes::synthetic_library();
  library.clips.resize(5);
  const char* const kNames[] = {"Duck Left", "duck/left", "duck_left",
                                "Bl\xc3\xb6"
                                "ck.01",
                                "duck_left_2"};
  for (std::size_t i = 0; i < 5; ++i) library.clips[i].name = kNames[i];
  std::vector<std::string> names;
  for (const NamedMotion& clip : exported_clips(library)) names.push_back(clip.name);
  EXPECT_THAT(names,
              ElementsAre("duck_left", "duck_left_2", "duck_left_3", "bl__ck_01", "duck_left_2_2"));
}

TEST(ClipExport, NamesOfFilesAreShortAndManyAlikeTakeNoTime) {
  ClipLibrary library = scenes::synthetic_library();
  motion::Clip clip = library.clips[1];
  clip.motion.poses.resize(1);
  clip.name = std::string(255, 'A');
  library.clips.assign(10'000, clip);
  const std::vector<NamedMotion> clips = exported_clips(library);
  EXPECT_EQ(clips.front().name, std::string(100, 'a'));
  EXPECT_EQ(clips.back().name, std::string(100, 'a') + "_10000");
}

TEST(ClipExport, EachClipKeepsItsMotionAndAnnotation) {
  const ClipLibrary library = scenes::synthetic_library();
  const std::vector<NamedMotion> clips = exported_clips(library);
  ASSERT_EQ(clips.size(), library.clips.size());
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const motion::Clip& clip = library.clips[i];
    EXPECT_EQ(clips[i].facts.clip, clip.name);
    EXPECT_EQ(clips[i].motion.poses.size(), clip.motion.poses.size());
    ASSERT_EQ(clips[i].facts.annotation.has_value(), clip.annotation.has_value());
    if (!clip.annotation) continue;
    EXPECT_EQ(clips[i].facts.annotation->peak_s, clip.annotation->peak_s);
  }
}

}  // namespace
}  // namespace flinch::database
