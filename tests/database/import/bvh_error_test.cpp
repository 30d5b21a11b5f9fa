// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "database/import/bvh.h"
#include "tests/database/import/bvh_samples.h"
#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using tests::kPlainBvh;
using tests::replaced;

std::string refusal_of(const std::string& text) {
  const std::string error = tests::error_of([&] { parse_bvh(text, "bad.bvh"); });
  EXPECT_EQ(error.find('\n'), std::string::npos) << "a message must be one line";
  return error;
}

// The sample with `what` replaced is rejected, with this line and these words in the message.
void expect_refused(const std::string& what, const std::string& with, int line,
                    const std::string& words) {
  const std::string error = refusal_of(replaced(kPlainBvh, what, with));
  EXPECT_THAT(error, StartsWith("bad.bvh:" + std::to_string(line) + ": ")) << with;
  EXPECT_THAT(error, HasSubstr(words));
}

TEST(BvhErrors, TextThatIsNotBvhIsRefused) {
  EXPECT_THAT(refusal_of(""), HasSubstr("bad.bvh: is empty"));
  EXPECT_THAT(refusal_of(" \r\n\t\n"), HasSubstr("bad.bvh: is empty"));
  EXPECT_THAT(refusal_of("\xEF\xBB\xBF"), HasSubstr("bad.bvh: is empty"));
  EXPECT_THAT(refusal_of("\n:version 1.10\n"), HasSubstr("bad.bvh:2: is not BVH"));
  EXPECT_THAT(refusal_of(std::string("HIERARCHY\0ROOT", 14)),
              HasSubstr("bad.bvh: byte 9: is binary"));
  EXPECT_THAT(refusal_of("\xFF\xFEH"), HasSubstr("UTF-16"));
  EXPECT_THAT(refusal_of("\x1B[31m\x07" + std::string(500, 'x')), HasSubstr("`?[31m?xxx"));
}

TEST(BvhErrors, AFigureNeedsOneRoot) {
  expect_refused("ROOT Hips", "JOINT Hips", 2, "expected ROOT");
  expect_refused("HIERARCHY\nROOT Hips\n{", "HIERARCHY\n", 3, "expected ROOT");
  expect_refused("MOTION", "ROOT Other\n{\n  OFFSET 0 0 0\n}\nMOTION", 21, "second ROOT");
  expect_refused("JOINT LeftUpLeg", "ROOT LeftUpLeg", 15, "found `ROOT`");
}

TEST(BvhErrors, BracesMustMatch) {
  expect_refused("JOINT Chest\n  {", "JOINT Chest\n", 8, "expected `{` of joint `Chest`");
  expect_refused("  }\n}\nMOTION", "  }\nMOTION", 20, "joint `Hips`");
  expect_refused("}\nMOTION", "}\n}\nMOTION", 21, "expected MOTION");
  expect_refused("4.5 0\n    }", "4.5 0\n", 21, "joint `Hips`, found `MOTION`");
}

TEST(BvhErrors, JointsMustBeComplete) {
  expect_refused("JOINT Chest", "JOINT", 6, "without a name");
  expect_refused("    OFFSET 3.91 0 0\n", "", 15, "`LeftUpLeg` has no OFFSET");
  expect_refused("OFFSET 3.91 0 0", "OFFSET 3.91 0 0 OFFSET 1 1 1", 17, "second OFFSET");
  expect_refused("OFFSET 3.91 0 0", "OFFSET 3.91 0", 18, "is `CHANNELS`");
  expect_refused("OFFSET 3.91 0 0", "OFFSET 3.91 0 0 0", 17, "found `0`");
  expect_refused("OFFSET 0 4.5 0", "", 13, "OFFSET of an End Site");
  expect_refused("OFFSET 0 4.5 0", "OFFSET 0 4.5 0 CHANNELS 3", 12, "End Site has CHANNELS");
  expect_refused("OFFSET 0 4.5 0", "OFFSET 0 4.5 0 OFFSET", 12, "`}` of an End Site");
}

TEST(BvhErrors, ChannelsMustBeKnownAndCounted) {
  const std::string channels = "CHANNELS 3 Zrotation Xrotation Yrotation";
  expect_refused(channels, "CHANNELS 4 Zrotation Xrotation Yrotation", 18, "says 4, but 3");
  expect_refused(channels, "CHANNELS 2 Zrotation Xrotation Yrotation", 18, "says 2, but 3");
  expect_refused(channels, "CHANNELS -1 Zrotation Xrotation Yrotation", 18, "says -1, but 3");
  expect_refused(channels, "CHANNELS 3 Zrotation Xrotation Yscale", 18, "`Yscale`");
  expect_refused(channels, "CHANNELS many Zrotation", 18, "whole number");
  expect_refused(channels, "CHANNELS 2 Xposition Xposition", 18, "two channels `Xposition`");
  expect_refused(channels, channels + "\n" + channels, 19, "second CHANNELS");
  expect_refused("  }\n}\nMOTION", "  }\n  CHANNELS 0\n}\nMOTION", 20, "second CHANNELS");
  const std::string first =
      "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
      "Yrotation\n";
  const std::string moved =
      replaced(replaced(kPlainBvh, first, ""), "  }\n}\n", "  }\n" + first + "}\n");
  EXPECT_THAT(refusal_of(moved), HasSubstr("bad.bvh:19: CHANNELS of joint `Hips` come after"));
}

TEST(BvhErrors, FilesWithoutChannelsAreRefused) {
  const std::string still =
      "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nMOTION\nFrames: 1\n"
      "Frame Time: 1\n";
  EXPECT_THAT(refusal_of(still), HasSubstr("no joint has CHANNELS"));
}

TEST(BvhErrors, MotionHeaderMustBeValid) {
  expect_refused("Frames: 2\n", "", 22, "expected `Frames:`");
  expect_refused("Frames: 2", "Frames: 0", 22, "at least one");
  expect_refused("Frames: 2", "Frames: -2", 22, "at least one");
  expect_refused("Frames: 2", "Frames: 2.5", 22, "whole number");
  expect_refused("Frames: 2", "Frames: 99999999999999999999", 22, "whole number");
  expect_refused("Frames: 2", "Frames: 9999999999", 22, "9999999999 frames");
  expect_refused("Frame Time: 0.25\n", "", 23, "expected `Frame Time:`");
  expect_refused("Frame Time: 0.25", "Frame Time: 0", 23, "above 0");
  expect_refused("Frame Time: 0.25", "Frame Time: -0.25", 23, "above 0");
  expect_refused("Frame Time: 0.25", "Frame Time: nan", 23, "finite");
  expect_refused("Frame Time: 0.25", "Frame Time: 0,25", 23, "decimal point");
}

TEST(BvhErrors, NumbersMustBeFinite) {
  for (const std::string number : {"nan", "-nan", "NaN", "inf", "-Infinity", "1e999", "-1.#IND",
                                   "1,5", "0x10", "--1", "+-1", "1e", ".", "-", "1.2.3", "12a"}) {
    expect_refused(" -8 ", " " + number + " ", 25, "but is `" + number + "`");
    expect_refused("5.21", number, 8, "but is `" + number + "`");
  }
}

TEST(BvhErrors, AFrameWithAValueTooFewOrTooManyIsFound) {
  const std::string frame = "-1 -2 -3 -4 -5 -6 -7 -8 -9 -10 -11 -12.5\n";
  const std::string text =
      replaced(replaced(kPlainBvh, "Frames: 2", "Frames: 4"), frame, frame + frame + frame);
  const std::string whole = frame + frame + frame;
  EXPECT_EQ(refusal_of(text), "");
  const std::string one_short = replaced(frame, "-10 ", "");
  EXPECT_THAT(refusal_of(replaced(text, whole, frame + one_short + frame)),
              AllOf(StartsWith("bad.bvh:26: frame 3"), HasSubstr("11 values"), HasSubstr("12 ")));
  const std::string one_long = replaced(frame, "-10 ", "-10 -10 ");
  EXPECT_THAT(refusal_of(replaced(text, whole, frame + one_long + frame)),
              AllOf(StartsWith("bad.bvh:26: frame 3"), HasSubstr("13 values")));
  // The total is right, but two frames in the middle have the wrong length.
  EXPECT_THAT(refusal_of(replaced(text, whole, one_short + one_long + frame)),
              StartsWith("bad.bvh:25: frame 2"));
}

TEST(BvhErrors, WrongCountsAreRefusedUnlessTheRowsAreBeyondDoubt) {
  // Half of the frames are missing.
  expect_refused("Frames: 2", "Frames: 4", 25, "2 whole frames of 12 values are there, but line");
  expect_refused("-12.5\n", "-12.5\nend of file\n", 26, "`end`");
  // No line is a frame, so that a wrong number of CHANNELS would look alike.
  const std::string halves = replaced(replaced(kPlainBvh, " 6 7 ", " 6\n7 "), " -7 ", "\n-7 ");
  EXPECT_EQ(refusal_of(halves), "");
  EXPECT_THAT(refusal_of(replaced(halves, "Frames: 2", "Frames: 3")),
              AllOf(StartsWith("bad.bvh:27: "), HasSubstr("declares 3 frames")));
  EXPECT_THAT(refusal_of(replaced(halves, "Frames: 2", "Frames: 1")),
              AllOf(StartsWith("bad.bvh:26: "), HasSubstr("declares 1 frame")));
}

// Would take 200 GB if the count were trusted.
TEST(BvhErrors, AnAbsurdFrameCountTakesNoMemory) {
  expect_refused("Frames: 2", "Frames: 2147483647", 25, "declares 2147483647 frames");
}

TEST(BvhErrors, TooManyOrTooDeepJointsAreRefused) {
  std::string deep = "HIERARCHY\nROOT a\n{ OFFSET 0 0 0\n";
  for (int i = 0; i < 100000; ++i) deep += "JOINT b\n{ OFFSET 0 0 0\n";
  EXPECT_THAT(refusal_of(deep), HasSubstr("256 deep"));
  std::string wide = "HIERARCHY\nROOT a\n{ OFFSET 0 0 0\n";
  for (int i = 0; i < 100000; ++i) wide += "JOINT b\n{ OFFSET 0 0 0 }\n";
  EXPECT_THAT(refusal_of(wide), HasSubstr("more than 4096 joints"));
}

TEST(BvhErrors, NamesUnreadableFiles) {
  EXPECT_THAT(tests::error_of([] { read_bvh("no/such/file.bvh"); }),
              AllOf(StartsWith("no/such/file.bvh: "), HasSubstr("No such file")));
  EXPECT_THAT(tests::error_of([] { read_bvh(FLINCH_SOURCE_DIR); }), HasSubstr("is a folder"));
}

}  // namespace
}  // namespace flinch::database
