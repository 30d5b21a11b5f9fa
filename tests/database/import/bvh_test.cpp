// SPDX-License-Identifier: MIT
#include "database/import/bvh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <clocale>
#include <locale>
#include <numbers>

#include "tests/database/import/bvh_samples.h"
#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::kPlainBvh;
using tests::replaced;

Bvh parse(const std::string& text) {
  return parse_bvh(text, "test.bvh");
}

// The sample with a replacement must still give the same figure and motion.
void expect_same_as_plain(const std::string& text) {
  const Bvh plain = parse(kPlainBvh);
  const Bvh other = parse(text);
  ASSERT_EQ(other.joints.size(), plain.joints.size());
  for (std::size_t i = 0; i < plain.joints.size(); ++i) {
    EXPECT_EQ(other.joints[i].name, plain.joints[i].name);
    EXPECT_EQ(other.joints[i].parent, plain.joints[i].parent);
    EXPECT_EQ(other.joints[i].offset, plain.joints[i].offset);
    EXPECT_EQ(other.joints[i].channels, plain.joints[i].channels);
    EXPECT_EQ(other.joints[i].first_channel, plain.joints[i].first_channel);
    EXPECT_EQ(other.joints[i].end_sites, plain.joints[i].end_sites);
  }
  EXPECT_EQ(other.frame_time_s, plain.frame_time_s);
  EXPECT_EQ(other.frame_count, plain.frame_count);
  EXPECT_EQ(other.values, plain.values);
}

TEST(Bvh, MatchesTheText) {
  const Bvh bvh = parse(kPlainBvh);
  EXPECT_EQ(bvh.path, "test.bvh");
  ASSERT_EQ(bvh.joints.size(), 3U);
  EXPECT_EQ(bvh.joints[0].name, "Hips");
  EXPECT_EQ(bvh.joints[1].name, "Chest");
  EXPECT_EQ(bvh.joints[2].name, "LeftUpLeg");
  EXPECT_EQ(bvh.joints[0].parent, -1);
  EXPECT_EQ(bvh.joints[1].parent, 0);
  EXPECT_EQ(bvh.joints[2].parent, 0);
  EXPECT_EQ(bvh.joints[1].offset, Eigen::Vector3d(0, 5.21, 0));
  EXPECT_THAT(bvh.joints[0].channels,
              ElementsAre(BvhChannel::x_position, BvhChannel::y_position, BvhChannel::z_position,
                          BvhChannel::z_rotation, BvhChannel::x_rotation, BvhChannel::y_rotation));
  EXPECT_THAT(bvh.joints[1].channels,
              ElementsAre(BvhChannel::z_rotation, BvhChannel::y_rotation, BvhChannel::x_rotation));
  EXPECT_EQ(bvh.joints[1].first_channel, 6);
  EXPECT_EQ(bvh.joints[2].first_channel, 9);
  EXPECT_THAT(bvh.joints[1].end_sites, ElementsAre(Eigen::Vector3d(0, 4.5, 0)));
  EXPECT_EQ(bvh.channel_count, 12);
  EXPECT_EQ(bvh.frame_count, 2);
  EXPECT_EQ(bvh.frame_time_s, 0.25);
  EXPECT_EQ(bvh.duration_s(), 0.25);
  EXPECT_THAT(bvh.values, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,  //
                                      -1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12.5));
  EXPECT_THAT(bvh.warnings, testing::IsEmpty());
}

TEST(Bvh, LineEndsBlanksAndMarksDoNotMatter) {
  const std::string plain = kPlainBvh;
  expect_same_as_plain(replaced(plain, "\n", "\r\n"));
  expect_same_as_plain(replaced(plain, "\n", "\r"));
  expect_same_as_plain(replaced(plain, "\n", "\n\n \t\n"));
  expect_same_as_plain(replaced(plain, "\n", " \t \n"));
  expect_same_as_plain(replaced(plain, " ", "\t"));
  expect_same_as_plain(replaced(plain, " ", "   "));
  expect_same_as_plain("\xEF\xBB\xBF" + plain);
  expect_same_as_plain("\n\n" + plain);
  expect_same_as_plain(plain.substr(0, plain.size() - 1));
  expect_same_as_plain(plain + "\n \r\n");
}

TEST(Bvh, CommentsDoNotMatter) {
  const std::string plain = kPlainBvh;
  expect_same_as_plain("# by a tool\n\n // 2\n" + plain);
  expect_same_as_plain("\xEF\xBB\xBF# by a tool\r\n" + plain);
  expect_same_as_plain(replaced(plain, "MOTION\n", "# JOINT {\nMOTION // here\n"));
  expect_same_as_plain(replaced(plain, "OFFSET 3.91 0 0", "OFFSET 3.91 0 0 # 1"));
  expect_same_as_plain(replaced(plain, "1 2 3", "# 0 0 0\n1 2 3"));
  expect_same_as_plain(replaced(plain, "12\n-1", "12 # frame 1\n-1"));
  EXPECT_EQ(parse(replaced(plain, "JOINT Chest\n", "JOINT Chest #1\n")).joints[1].name, "Chest #1");
}

TEST(Bvh, WholeFramesAreReadWithAWarningWhereTheirNumberIsNotAsDeclared) {
  const std::string plain = kPlainBvh;
  const auto expect_frames = [](const std::string& text, int frames, const std::string& words) {
    const Bvh bvh = parse(text);
    EXPECT_EQ(bvh.frame_count, frames);
    ASSERT_EQ(bvh.values.size(), static_cast<std::size_t>(12 * frames));
    EXPECT_EQ(bvh.values[11], 12);
    EXPECT_THAT(bvh.warnings, ElementsAre(AllOf(HasSubstr("test.bvh:"), HasSubstr(words))));
  };
  expect_frames(replaced(plain, "Frames: 2", "Frames: 3"), 2,
                "test.bvh:25: 2 whole frames of 12 values are there, but line 22 declares 3 frames;"
                " the whole frames are read, but the file may be cut short");
  expect_frames(replaced(plain, "Frames: 2", "Frames: 1"), 2, "declares 1 frame;");
  expect_frames(plain + "\n7\n", 2, "2 whole frames and 1 value of another");
  const std::string row = "0 0 0 0 0 0 0 0 0 0 0 0\n";
  expect_frames(replaced(plain, "Frames: 2", "Frames: 4") + row + "0 0 0\n", 3,
                "3 whole frames and 3 values of another");
}

TEST(Bvh, ChannelsOfNoneAreNoChannels) {
  const std::string plain = kPlainBvh;
  expect_same_as_plain(replaced(plain, "OFFSET 0 4.5 0", "OFFSET 0 4.5 0\nCHANNELS 0"));
  const std::string channels = "    CHANNELS 3 Zrotation Yrotation Xrotation\n";
  const auto without = [&](const std::string& with) {
    return replaced(replaced(replaced(plain, channels, with), " 7 8 9 ", " "), " -7 -8 -9 ", " ");
  };
  EXPECT_EQ(parse(without("    CHANNELS 0\n")).values, parse(without("")).values);
}

TEST(Bvh, KeywordsMayHaveAnyCase) {
  std::string text = kPlainBvh;
  for (const std::string word : {"HIERARCHY", "ROOT", "OFFSET", "CHANNELS", "JOINT", "End Site",
                                 "MOTION", "Frames", "Frame Time", "Xposition", "Zrotation"}) {
    std::string lower = word;
    for (char& c : lower) c = static_cast<char>(std::tolower(c));
    text = replaced(text, word, lower);
  }
  expect_same_as_plain(text);
  expect_same_as_plain(replaced(kPlainBvh, "End Site", "END SITE"));
  expect_same_as_plain(replaced(kPlainBvh, "End Site", "EndSite"));
  expect_same_as_plain(replaced(kPlainBvh, "End Site", "End Site HeadTop"));
}

TEST(Bvh, TheHeaderOfTheMotionMayBeWrittenTightOrLoose) {
  expect_same_as_plain(replaced(kPlainBvh, "Frames: 2", "Frames:2"));
  expect_same_as_plain(replaced(kPlainBvh, "Frames: 2", "Frames:\t2 "));
  expect_same_as_plain(replaced(kPlainBvh, "Frames: 2", "Frames :    2"));
  expect_same_as_plain(replaced(kPlainBvh, "Frames: 2", "FRAMES 2"));
  expect_same_as_plain(replaced(kPlainBvh, "Frame Time: 0.25", "Frame Time:0.25"));
  expect_same_as_plain(replaced(kPlainBvh, "Frame Time: 0.25", "Frame  Time:\t.25"));
  expect_same_as_plain(replaced(kPlainBvh, "Frame Time: 0.25", "Frame Time: 2.5e-1"));
  expect_same_as_plain(replaced(kPlainBvh, "Frame Time: 0.25", "frame time 0.2500000"));
}

TEST(Bvh, NumbersMayBeWrittenInEveryCommonWay) {
  expect_same_as_plain(replaced(kPlainBvh, "5.21", "5.21e0"));
  expect_same_as_plain(replaced(kPlainBvh, "5.21", "+0.521E+01"));
  expect_same_as_plain(replaced(kPlainBvh, "-12.5", "-1.25e+001"));
  expect_same_as_plain(replaced(kPlainBvh, " 11 ", " 11. "));
  EXPECT_EQ(parse(replaced(kPlainBvh, "-12.5", "-1.5e-320")).values.back(), -1.5e-320);
}

TEST(Bvh, FramesMayBeBrokenOverLines) {
  expect_same_as_plain(replaced(kPlainBvh, "3 4 5", "3\n4 5"));
  expect_same_as_plain(replaced(kPlainBvh, " 8 9 ", "\n\n8\r\n 9\t"));
  expect_same_as_plain(replaced(kPlainBvh, " 12\n-1 ", " 12 -1 "));  // two frames on one line
}

TEST(Bvh, TextWrappedWithoutRegardToFramesIsReadWithAWarning) {
  const std::string wrapped = replaced(
      replaced(replaced(kPlainBvh, " 12\n-1 ", " 12 -1 "), " 9 ", "\n9 "), " -9 ", "\n-9 ");
  expect_same_as_plain(wrapped);
  EXPECT_THAT(parse(wrapped).warnings, ElementsAre(HasSubstr("test.bvh:24: ")));
}

TEST(Bvh, NamesMayHoldDotsColonsBlanksAndOtherAlphabets) {
  const auto name_of = [](const std::string& line) {
    return parse(replaced(kPlainBvh, "JOINT Chest\n", line)).joints[1].name;
  };
  EXPECT_EQ(name_of("JOINT pelvis.R\n"), "pelvis.R");
  EXPECT_EQ(name_of("JOINT mixamorig:Hips\n"), "mixamorig:Hips");
  EXPECT_EQ(name_of("JOINT  Left Upper  Arm \t\r\n"), "Left Upper  Arm");
  EXPECT_EQ(name_of("JOINT \xE5\xB7\xA6\xE8\x85\x95\n"), "\xE5\xB7\xA6\xE8\x85\x95");
  EXPECT_EQ(name_of("JOINT End\n"), "End");
  EXPECT_EQ(parse(replaced(kPlainBvh, "JOINT Chest\n  {", "JOINT Chest {")).joints[1].name,
            "Chest");
}

TEST(Bvh, NamesThatAreNotUtf8AreReadAsLatin1WithAWarning) {
  const Bvh bvh =
      parse(replaced(replaced(kPlainBvh, "Chest", "K\xF6rper"), "LeftUpLeg", "\xFC\x1B"));
  EXPECT_EQ(bvh.joints[1].name, "K\u00F6rper");
  EXPECT_EQ(bvh.joints[2].name, "\u00FC?");
  EXPECT_THAT(bvh.warnings, ElementsAre(AllOf(HasSubstr("test.bvh:6: "), HasSubstr("Latin-1"),
                                              HasSubstr("`K\u00F6rper`"))));
}

TEST(Bvh, JointsMayHaveNoneOrManyEndSites) {
  const std::string site = "    End Site\n    {\n      OFFSET 0 4.5 0\n    }\n";
  EXPECT_THAT(parse(replaced(kPlainBvh, site, "")).joints[1].end_sites, testing::IsEmpty());
  const std::string other = replaced(site, "4.5", "1e1");
  EXPECT_THAT(parse(replaced(kPlainBvh, site, site + other)).joints[1].end_sites,
              ElementsAre(Eigen::Vector3d(0, 4.5, 0), Eigen::Vector3d(0, 10, 0)));
}

TEST(Bvh, EveryJointHasItsOwnChannels) {
  const std::string channels = "CHANNELS 3 Zrotation Yrotation Xrotation";
  const Bvh bvh =
      parse(replaced(kPlainBvh, channels, "CHANNELS 3\nYrotation\n\tXposition Zposition"));
  EXPECT_THAT(bvh.joints[1].channels,
              ElementsAre(BvhChannel::y_rotation, BvhChannel::x_position, BvhChannel::z_position));
  const Bvh fixed =
      parse(replaced(replaced(replaced(kPlainBvh, "    " + channels + "\n", ""), " 7 8 9 ", " "),
                     " -7 -8 -9 ", " "));
  EXPECT_THAT(fixed.joints[1].channels, testing::IsEmpty());
  EXPECT_EQ(fixed.joints[2].first_channel, 6);
}

// Z, X, Z as Euler's own angles have it: the turns follow each other.
TEST(Bvh, ARotationNamedTwiceIsReadInTheOrderOfTheChannelsWithAWarning) {
  const std::string plain = kPlainBvh;
  const Bvh bvh = parse_bvh(
      replaced(plain, "Zrotation Yrotation Xrotation", "Zrotation Xrotation zrotation"), "a.bvh");
  EXPECT_THAT(bvh.warnings, testing::ElementsAre(
                                "a.bvh:9: joint `Chest` has two channels `zrotation`; their turns "
                                "follow each other in the order of the channels"));
  const auto turn = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees / 180 * std::numbers::pi, axis);
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Eigen::Quaterniond expected =
      turn(4, z) * turn(5, x) * turn(6, y) * turn(7, z) * turn(8, x) * turn(9, z);
  EXPECT_LT(forward_kinematics(bvh, 0).orientation[1].angularDistance(expected), 1e-7);
  EXPECT_THAT(parse_bvh(plain, "a.bvh").warnings, testing::IsEmpty());
}

TEST(Bvh, JointsOfTheSameNameGiveAWarning) {
  EXPECT_THAT(parse(replaced(kPlainBvh, "LeftUpLeg", "Chest")).warnings,
              ElementsAre(AllOf(HasSubstr("test.bvh:15: "), HasSubstr("Chest"))));
}

/// Formats numbers as in much of Europe: 1.234,5.
class CommaForPoint : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
};

TEST(Bvh, ParsesIndependentlyOfTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaForPoint));
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // for the C library, where it is installed
  double parsed = 0;
  const std::string error =
      tests::error_of([&] { parsed = parse(kPlainBvh).joints.at(1).offset.y(); });
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(error, "");
  EXPECT_EQ(parsed, 5.21);
}

}  // namespace
}  // namespace flinch::database
