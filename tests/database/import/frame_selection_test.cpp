// SPDX-License-Identifier: MIT
#include "database/import/frame_selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A joint whose two values in frame n, from 1, are n and -n.
Bvh counting(int frames) {
  Bvh bvh;
  bvh.path = "count.bvh";
  bvh.joints.resize(1);
  bvh.joints[0].channels = {BvhChannel::x_position, BvhChannel::y_position};
  bvh.channel_count = 2;
  bvh.frame_count = frames;
  bvh.frame_time_s = 0.5;
  for (int n = 1; n <= frames; ++n) bvh.values.insert(bvh.values.end(), {1.0 * n, -1.0 * n});
  return bvh;
}

Bvh selected(Bvh bvh, const FrameOptions& options) {
  select_frames(bvh, options);
  return bvh;
}

std::string refusal_of(int frames, const FrameOptions& options) {
  return tests::error_of([&] { selected(counting(frames), options); });
}

TEST(FrameSelection, ReadsRangesOfFramesAndNothingElse) {
  const auto read = [](const std::string& text) {
    const std::optional<FrameRange> range = frame_range_from(text);
    return range ? text_of(*range) : "";
  };
  EXPECT_EQ(read("2:90"), "2:90");
  EXPECT_EQ(read("7:7"), "7:7");
  EXPECT_EQ(read("2:"), "2:");
  EXPECT_EQ(read(":90"), "1:90");
  for (const std::string text : {"", ":", "2", "0:3", "-1:3", "3:2", "a:b", "1:2:3", " 1:2", "1:2x",
                                 "1.5:3", "99999999999:", "1-2"}) {
    EXPECT_FALSE(frame_range_from(text)) << text;
  }
}

TEST(FrameSelection, LeavesTheFramesOfTheRangeAndKnowsWhereTheyBegan) {
  const Bvh bvh = selected(counting(5), {.range = FrameRange{2, 4}});
  EXPECT_THAT(bvh.values, ElementsAre(2, -2, 3, -3, 4, -4));
  EXPECT_EQ(bvh.frame_count, 3);
  EXPECT_EQ(bvh.first_frame, 1);
  EXPECT_EQ(bvh.start_s(), 0.5);
  EXPECT_EQ(bvh.duration_s(), 1);
  EXPECT_THAT(selected(counting(3), {.range = FrameRange{3, {}}}).values, ElementsAre(3, -3));
  EXPECT_EQ(selected(counting(3), {}).values, counting(3).values);
}

TEST(FrameSelection, SkippingTheFirstLeavesOutFrameOneOnly) {
  const FrameOptions skip{.skip_first = true};
  EXPECT_THAT(selected(counting(3), skip).values, ElementsAre(2, -2, 3, -3));
  EXPECT_EQ(selected(counting(3), skip).first_frame, 1);
  EXPECT_THAT(selected(counting(3), {.range = FrameRange{2, 2}, .skip_first = true}).values,
              ElementsAre(2, -2));
  EXPECT_THAT(selected(counting(1), {.skip_first = false}).values, ElementsAre(1, -1));
}

TEST(FrameSelection, TheRateGivenReplacesTheFiles) {
  const Bvh bvh = selected(counting(5), {.rate_hz = 100, .range = FrameRange{3, 5}});
  EXPECT_DOUBLE_EQ(bvh.frame_time_s, 0.01);
  EXPECT_DOUBLE_EQ(bvh.start_s(), 0.02);
}

TEST(FrameSelection, FramesThatAreNotThereAreRefused) {
  EXPECT_THAT(refusal_of(5, {.range = FrameRange{2, 6}}),
              HasSubstr("count.bvh: has 5 frames, so not the frames 2:6"));
  EXPECT_THAT(refusal_of(5, {.range = FrameRange{6, {}}}), HasSubstr("not the frames 6:"));
  EXPECT_THAT(refusal_of(1, {.skip_first = true}), HasSubstr("no frame after its first"));
}

TEST(FrameSelection, RatesThatNoMotionCaptureHasAreRefusedUnlessAnotherIsGiven) {
  for (const double frame_time_s : {1e-9, 1e-300, 5e-5, 11.0, 1e6, 1e300}) {
    Bvh bvh = counting(3);
    bvh.frame_time_s = frame_time_s;
    EXPECT_THAT(tests::error_of([&] { selected(bvh, {}); }),
                testing::AllOf(HasSubstr("s per frame"), HasSubstr("--rate-of-file")))
        << frame_time_s;
    EXPECT_EQ(selected(bvh, {.rate_hz = 50}).frame_time_s, 0.02);
  }
}

TEST(FrameSelection, AMillionFramesAreAllowedAndNoMore) {
  EXPECT_EQ(refusal_of(kMaxFrames, {}), "");
  EXPECT_THAT(refusal_of(kMaxFrames + 1, {}), HasSubstr("choose some with --frames A:B"));
  EXPECT_EQ(refusal_of(kMaxFrames + 1, {.skip_first = true}), "");
}

}  // namespace
}  // namespace flinch::database
