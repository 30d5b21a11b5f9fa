// SPDX-License-Identifier: MIT
#include "database/import/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "database/import/import.h"
#include "database/import/loop_closing.h"
#include "database/import/retarget.h"
#include "database/import/role_map.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "tests/database/import/synthetic_figure.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using tests::error_of;
using tests::TemporaryFolder;

constexpr const char* kIdle = "[[idle]]\nname = \"idle\"\nfile = \"a.bvh\"\n";  // lines 1 to 3

std::string clip_with(const std::string& lines) {
  return std::string(kIdle) + "[[clip]]\nname = \"duck\"\nfile = \"a.bvh\"\n" + lines;
}

Manifest manifest_of(const TemporaryFolder& folder, const std::string& text) {
  return read_manifest(folder.write("manifest.toml", text));
}

constexpr const char* kAnnotated =
    "start = 0.5\nend = 1.5\nonset = 0.6\npeak = 1.0\ntarget = \"trunk\"\ndirection = 90\n"
    "degree = \"mild\"\n";

TEST(Manifest, MatchesTheFile) {
  const TemporaryFolder folder;
  const Manifest manifest = manifest_of(
      folder,
      clip_with(std::string(kAnnotated) + "kind = \"duck\"\nheading = -30\n") +
          "[[push]]\nname = \"push\"\nfile = \"b/c.bvh\"\ncontact = 2\nstrength = \"mild\"\n"
          "direction = 170\nplace = \"right_shoulder\"\n"
          "[library]\nname = \"real\"\nrate = 50\nskeleton = \"b/c.bvh\"\n"
          "[character]\nmass_kg = 60\nsex = \"female\"\nheight_m = 1.7\n"
          "[source.\"b\"]\nunits = \"inch\"\nup = \"-z\"\nrest = \"b/t.bvh\"\nskip_first = true\n"
          "frames = \"2:90\"\n"
          "[source.\"b/c.bvh\"]\nunits = \"cmu\"\nroles = { head = \"Kopf\" }\nrate_of_file = "
          "59.94\n"
          "skip_first = false\n");
  EXPECT_EQ(manifest.name, "real");
  EXPECT_EQ(manifest.rate_hz, 50);
  EXPECT_EQ(manifest.skeleton, "b/c.bvh");
  EXPECT_EQ(manifest.character.mass_kg, 60);
  EXPECT_EQ(manifest.character.height_m, 1.7F);
  EXPECT_EQ(manifest.character.sex, motion::Sex::female);
  ASSERT_EQ(manifest.entries.size(), 3U);
  const ManifestEntry& clip = manifest.entries[1];
  EXPECT_EQ(clip.name, "duck");
  EXPECT_EQ(clip.purpose, motion::Purpose::anticipation);
  EXPECT_EQ(clip.start_s, 0.5);
  EXPECT_EQ(clip.end_s, 1.5);
  EXPECT_NEAR(clip.heading, -std::numbers::pi / 6, 1e-9);
  ASSERT_TRUE(clip.annotation);
  EXPECT_EQ(clip.annotation->target, motion::Target::trunk);
  EXPECT_NEAR(clip.annotation->direction, std::numbers::pi / 2, 1e-6);
  EXPECT_EQ(manifest.entries[2].purpose, motion::Purpose::push);
  EXPECT_FALSE(manifest.entries[2].annotation);
  ASSERT_TRUE(manifest.entries[2].push);
  EXPECT_EQ(manifest.entries[2].push->contact_s, 2);
  EXPECT_NEAR(manifest.entries[2].push->direction.value(), 2.967, 1e-3);
  EXPECT_EQ(manifest.entries[2].push->place, motion::Role::right_upper_arm);

  const SourceOptions options = options_for(manifest, "b/c.bvh");
  EXPECT_EQ(options.unit, LengthUnit::cmu);  // the longer path wins
  EXPECT_EQ(options.up, UpAxis::minus_z);
  EXPECT_EQ(options.roles.at(motion::Role::head), "Kopf");
  EXPECT_EQ(options.rest, "b/t.bvh");
  EXPECT_EQ(options.frames.rate_hz, 59.94);
  EXPECT_EQ(text_of(options.frames.range.value()), "2:90");
  EXPECT_EQ(options.frames.skip_first, false);
  EXPECT_EQ(options_for(manifest, "b/d.bvh").frames.skip_first, true);
  EXPECT_FALSE(options_for(manifest, "bb/c.bvh").unit);
}

TEST(Manifest, SnapsDirectionsToTheNearestOfEight) {
  const TemporaryFolder folder;
  const std::pair<double, double> cases[] = {{20, 0},     {-30, -45}, {110, 90},   {-180, 180},
                                             {-170, 180}, {179, 180}, {-135, -135}};
  for (const auto& [written, taken] : cases) {
    std::string text = kAnnotated;
    text.replace(text.find("90"), 2, std::to_string(written));
    const Manifest manifest = manifest_of(folder, clip_with(text));
    EXPECT_NEAR(manifest.entries[1].annotation->direction, taken * std::numbers::pi / 180, 1e-6);
  }
}

struct BadManifest {
  std::string text;
  std::string message;  // part of the expected error
};

TEST(Manifest, RefusesErrorsWithFileAndLine) {
  const std::string annotated = kAnnotated;
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = annotated;
    text.replace(text.find(from), from.size(), to);
    return clip_with(text);
  };
  const BadManifest cases[] = {
      {"a = \n", "manifest.toml:1: not TOML: "},
      {"", "manifest.toml: has no [[idle]]"},
      {"[[clip]]\nname = \"a\"\nfile = \"b\"\n", "has no [[idle]]"},
      {std::string(kIdle) + "[[clap]]\nname = \"a\"\n",
       "manifest.toml:4: the manifest has an unknown key \"clap\"; it may have: library"},
      {clip_with("pek = 1\n"), "manifest.toml:7: [[clip]] has an unknown key \"pek\""},
      {clip_with("start = \"0\"\n"), "manifest.toml:7: [[clip]] needs a number for start"},
      {clip_with("start = nan\n"), "manifest.toml:7: [[clip]] needs a number for start"},
      {clip_with("start = -1\n"), "manifest.toml:7: [[clip]] starts before its file"},
      {clip_with("start = 1\nend = 1\n"), "manifest.toml:8: [[clip]] must end after it starts"},
      {clip_with("target = \"head\"\n"), "manifest.toml:7: [[clip]] is annotated but has no direc"},
      {changed("trunk", "knee"),
       "manifest.toml:11: [[clip]] has an unknown target \"knee\"; known are: head, trunk, pelvis, "
       "legs"},
      {changed("mild", "mad"), "manifest.toml:13: [[clip]] has an unknown degree \"mad\""},
      {changed("90", "190"), "manifest.toml:12: [[clip]] needs direction from -180 to 180"},
      {changed("0.6", "0.4"), "manifest.toml:9: [[clip]] has its onset outside start to end"},
      {changed("1.0", "1.6"), "manifest.toml:10: [[clip]] has its peak outside start to end"},
      {changed("0.6", "1.0"), "manifest.toml:10: [[clip]] needs its peak after its onset"},
      {std::string(kIdle) + "[[clip]]\nfile = \"a\"\n", "manifest.toml:4: [[clip]] needs name"},
      {std::string(kIdle) + kIdle, "manifest.toml:4: the name \"idle\" is already taken at"},
      {std::string(kIdle) + "[clip]\n", "manifest.toml:4: the manifest needs [[clip]]"},
      {std::string(kIdle) + "[library]\nrate = 0\n",
       "manifest.toml:5: [library] needs rate from 10"},
      {std::string(kIdle) + "[library]\nrate = 1e6\n",
       "manifest.toml:5: [library] needs rate from 10 to 1000"},
      {std::string(kIdle) + "[source.a]\nrate_of_file = 1e9\n",
       "manifest.toml:5: [source.\"a\"] needs rate_of_file from 0.1 to 10000"},
      {std::string(kIdle) + "[source.a]\nframes = \"9:2\"\n",
       "manifest.toml:5: [source.\"a\"] needs frames = \"FIRST:LAST\""},
      {std::string(kIdle) + "[source.a]\nskip_first = 1\n",
       "manifest.toml:5: [source.\"a\"] needs true or false for skip_first"},
      {std::string(kIdle) + "[character]\nsex = \"x\"\n",
       "manifest.toml:5: [character] has an unknown sex \"x\"; known are: female, male"},
      {std::string(kIdle) + "[source.a]\nunits = \"feet\"\n",
       "manifest.toml:5: [source.\"a\"] has an unknown units \"feet\"; known are: m, cm"},
      {std::string(kIdle) + "[source.a]\nroles = { haed = \"b\" }\n",
       "manifest.toml:5: [source.\"a\".roles] names an unknown role \"haed\""},
  };
  const TemporaryFolder folder;
  for (const BadManifest& bad : cases) {
    const std::string message = error_of([&] { manifest_of(folder, bad.text); });
    EXPECT_THAT(message, HasSubstr(bad.message)) << bad.text;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

// Writes a second of standing as a BVH file.
void write_standing(const std::string& path) {
  std::ofstream file(path);
  const Bvh bvh = tests::synthetic_bvh(
      motion::default_character().skeleton, tests::SyntheticRig(),
      std::vector<motion::Pose>(31, rest_pose(motion::default_character().skeleton)), 1.0 / 30);
  std::vector<std::string> closing;
  file << "HIERARCHY\n";
  std::vector<int> open;
  for (std::size_t i = 0; i < bvh.joints.size(); ++i) {
    const BvhJoint& joint = bvh.joints[i];
    while (!open.empty() && open.back() != joint.parent) {
      file << "}\n";
      open.pop_back();
    }
    file << (i == 0 ? "ROOT " : "JOINT ") << joint.name << "\n{\nOFFSET "
         << joint.offset.transpose() << "\nCHANNELS " << joint.channels.size()
         << (i == 0 ? " Xposition Yposition Zposition" : "") << " Zrotation Xrotation Yrotation\n";
    for (const Eigen::Vector3d& site : joint.end_sites) {
      file << "End Site\n{\nOFFSET " << site.transpose() << "\n}\n";
    }
    open.push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < open.size(); ++i) file << "}\n";
  file << "MOTION\nFrames: " << bvh.frame_count << "\nFrame Time: " << bvh.frame_time_s << "\n";
  for (int frame = 0; frame < bvh.frame_count; ++frame) {
    for (int i = 0; i < bvh.channel_count; ++i) {
      file << bvh.values[static_cast<std::size_t>(frame * bvh.channel_count + i)] << ' ';
    }
    file << "\n";
  }
}

TEST(Import, CutsClipsAndMirrorsTheAnnotatedOnes) {
  const TemporaryFolder folder;
  write_standing(folder / "a.bvh");
  std::string text = clip_with(
      "start = 0.2\nend = 0.9\nonset = 0.3\npeak = 0.5\ntarget = \"legs\"\ndirection = -45\n"
      "degree = \"exaggerated\"\n");
  text += "[[clip]]\nname = \"plain\"\nfile = \"a.bvh\"\n";
  folder.write("m.toml", text);
  const ImportResult result = import_library({}, folder / "m.toml");
  const ClipLibrary& library = result.library;
  EXPECT_EQ(library.name, "m");
  EXPECT_EQ(library.rate_hz, 60);
  ASSERT_EQ(library.clips.size(), 4U);
  EXPECT_EQ(library.idle_clip().name, "idle");
  const motion::Clip& duck = library.clips[1];
  EXPECT_EQ(duck.motion.poses.size(), 43U);
  EXPECT_NEAR(duck.annotation->onset_s, 0.1, 1e-6);
  EXPECT_NEAR(duck.annotation->peak_s, 0.3, 1e-6);
  EXPECT_NEAR(duck.annotation->end_s, 0.7, 1e-6);
  EXPECT_EQ(library.clips[2].name, "duck_mirrored");
  EXPECT_EQ(library.clips[2].mirrored_from, "duck");
  EXPECT_NEAR(library.clips[2].annotation->direction, std::numbers::pi / 4, 1e-6);
  EXPECT_EQ(library.clips[3].name, "plain");
  EXPECT_FALSE(library.clips[3].annotation);
  EXPECT_EQ(library.clips[3].motion.poses.size(), 61U);
  ASSERT_EQ(result.report.warnings.size(), 1U);
  EXPECT_THAT(result.report.warnings.front(), HasSubstr("1 clips are not annotated"));
  EXPECT_EQ(result.report.sources.size(), 1U);
}

// Times count from the beginning of the file, whichever of its frames are used.
TEST(Import, TimesStayThoseOfTheFileWhereOnlySomeFramesAreUsed) {
  const TemporaryFolder folder;
  write_standing(folder / "a.bvh");  // 31 frames at 30 Hz
  const std::string clip = clip_with(
      "start = 0.5\nend = 0.9\nonset = 0.6\npeak = 0.7\ntarget = \"legs\"\ndirection = 0\n"
      "degree = \"mild\"\n");
  folder.write("m.toml", clip + "[source.\"a.bvh\"]\nframes = \"4:31\"\n");
  const ClipLibrary library = import_library({}, folder / "m.toml").library;
  EXPECT_EQ(library.clips[0].motion.poses.size(), 55U);  // the idle: all that is used, 0.9 s
  EXPECT_EQ(library.clips[1].motion.poses.size(), 25U);
  EXPECT_NEAR(library.clips[1].annotation->onset_s, 0.1, 1e-6);
  EXPECT_NEAR(library.clips[1].annotation->peak_s, 0.2, 1e-6);
  folder.write("m.toml", clip + "[source.\"a.bvh\"]\nframes = \"19:\"\n");
  EXPECT_THAT(error_of([&] { import_library({}, folder / "m.toml"); }),
              HasSubstr("[0.500 s, 0.900 s] is outside \"a.bvh\", of which the frames from 0.600 s "
                        "to 1.000 s are used"));
}

TEST(Import, ClipsOfMoreThanAMillionFramesAreRefused) {
  const TemporaryFolder folder;
  write_standing(folder / "a.bvh");
  folder.write("m.toml", std::string(kIdle) + "[source.\"a.bvh\"]\nrate_of_file = 0.1\n");
  EXPECT_EQ(import_library({}, folder / "m.toml").library.clips[0].motion.poses.size(), 18001U);
  const Segment long_segment{10, 10 + (kMaxFrames - 1) / 60.0, 0};
  EXPECT_EQ(error_of([&] { check_frame_count("m.toml:3", long_segment, 60); }), "");
  EXPECT_THAT(error_of([&] { check_frame_count("m.toml:3", long_segment, 60.01F); }),
              AllOf(HasSubstr("m.toml:3: lasts 16666.7 s"), HasSubstr("--rate-of-file")));
}

TEST(Import, MirrorsPushes) {
  const TemporaryFolder folder;
  write_standing(folder / "a.bvh");
  const std::string push = "[[push]]\nname = \"shove\"\nfile = \"a.bvh\"\n";
  folder.write("m.toml", std::string(kIdle) + push);
  const ClipLibrary library = import_library({}, folder / "m.toml").library;
  ASSERT_EQ(library.clips.size(), 3U);
  EXPECT_EQ(library.clips[2].name, "shove_mirrored");
  EXPECT_EQ(library.clips[2].purpose, motion::Purpose::push);
  EXPECT_EQ(library.clips[2].mirrored_from, "shove");
  folder.write("m.toml", std::string(kIdle) + push +
                             "[[clip]]\nname = \"shove_mirrored\"\nfile = \"a.bvh\"\n");
  EXPECT_THAT(error_of([&] { import_library({}, folder / "m.toml"); }),
              HasSubstr("the name \"shove_mirrored\" is already taken"));
}

TEST(Import, StancesLoopWhereTheirMotionNearlyDoes) {
  const TemporaryFolder folder;
  write_standing(folder / "a.bvh");
  const std::string stance = "[[stance]]\nname = \"guard\"\nkind = \"guard\"\nfile = \"a.bvh\"\n";
  folder.write("m.toml", std::string(kIdle) + stance);
  const ClipLibrary library = import_library({}, folder / "m.toml").library;
  ASSERT_EQ(stance_clips(library), (std::vector<int>{0, 1}));
  EXPECT_EQ(library.clips[1].kind, "guard");
  const motion::LoopGap gap = motion::loop_gap(library.clips[1].motion);
  EXPECT_LT(gap.angle, motion::kMaxLoopGap);
  EXPECT_LT(gap.height_m, motion::kMaxLoopGap_m);
}

TEST(ClosedLoop, SpreadsASmallGapAndSaysByHowMuchALargeOneIsTooLarge) {
  motion::Motion motion;
  for (int k = 0; k <= 60; ++k) {
    const float share = static_cast<float>(k) / 60;
    motion::Pose pose;
    pose.root_position = {1.2F * share, 0.02F * share, 1 - 0.03F * share};
    pose.rotation[motion::Role::left_forearm] =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), -motion::radians(12) * share);
    motion.poses.push_back(pose);
  }
  const motion::Motion closed = closed_loop(motion, "m.toml:7");
  EXPECT_LT(motion::loop_gap(closed).angle, 1e-3F);
  EXPECT_LT(motion::loop_gap(closed).height_m, 1e-5F);
  EXPECT_NEAR(motion::Loop::in_cycles(closed).travel().translation.x(), 1.2F, 1e-5F);
  EXPECT_NEAR(closed.poses[30].root_position.z(), 1, 1e-5F);
  motion.poses.back().rotation[motion::Role::right_shin] =
      motion::rotation_about(Eigen::Vector3f::UnitY(), motion::radians(31));
  EXPECT_THAT(error_of([&] { closed_loop(motion, "m.toml:7"); }),
              AllOf(HasSubstr("m.toml:7: does not loop"), HasSubstr("height differs by 3.0 cm"),
                    HasSubstr("right_shin by 31 degrees; at most 5 cm and 20 degrees")));
}

TEST(Import, MeasuresPushesAndNotesWhereNothingIsPushed) {
  const TemporaryFolder folder;
  write_standing(folder / "a.bvh");
  const std::string push = "[[push]]\nname = \"shove\"\nfile = \"a.bvh\"\n";
  folder.write("m.toml", std::string(kIdle) + push);
  const ImportResult still = import_library({}, folder / "m.toml");
  EXPECT_FALSE(still.library.clips[1].push);
  EXPECT_THAT(still.report.clips[1].warnings,
              testing::Contains(HasSubstr("nothing moves as if pushed")));
  EXPECT_THAT(error_of([&] {
                folder.write("m.toml", std::string(kIdle) + push + "place = \"left_foot\"\n");
                import_library({}, folder / "m.toml");
              }),
              AllOf(HasSubstr("m.toml:7: "), HasSubstr("unknown place \"left_foot\""),
                    HasSubstr("left_shoulder")));
}

TEST(Import, RefusesFilesThatAreNotThereAndTimesOutsideThem) {
  const TemporaryFolder folder;
  write_standing(folder / "a.bvh");
  const auto message_for = [&](const std::string& text) {
    folder.write("m.toml", text);
    return error_of([&] { import_library({folder.path()}, folder / "m.toml"); });
  };
  EXPECT_THAT(message_for(clip_with("start = 0.5\nend = 1.2\n")),
              HasSubstr("m.toml:4: [0.500 s, 1.200 s] is outside \"a.bvh\", which lasts 1.000 s"));
  EXPECT_THAT(message_for(std::string(kIdle) + "[[clip]]\nname = \"b\"\nfile = \"b.bvh\"\n"),
              HasSubstr("m.toml:4: the file \"b.bvh\" is in none of: " + folder.path()));
  EXPECT_THAT(message_for(std::string(kIdle) + "[library]\nskeleton = \"c.bvh\"\n"),
              HasSubstr("m.toml:5: the file \"c.bvh\""));
  EXPECT_THAT(error_of([&] { import_library({folder / "nowhere"}, folder / "m.toml"); }),
              EndsWith("nowhere: there is no such file or folder"));
}

TEST(Import, WithoutAManifestTakesEveryFileAndSkipsWhatItCannotUse) {
  const TemporaryFolder folder;
  write_standing(folder / "stand.bvh");
  write_standing(folder / "z_idle.BVH");
  folder.write("bad.bvh", "not a BVH file\n");
  const ImportResult result = import_library({folder.path()}, std::nullopt);
  ASSERT_EQ(result.library.clips.size(), 2U);
  EXPECT_EQ(result.library.clips[0].name, "stand");
  EXPECT_EQ(result.library.clips[0].purpose, motion::Purpose::anticipation);
  EXPECT_EQ(result.library.idle, 1);
  EXPECT_EQ(result.library.clips[1].purpose, motion::Purpose::idle);
  ASSERT_EQ(result.report.skipped.size(), 1U);
  EXPECT_THAT(result.report.skipped.front().reason, HasSubstr("bad.bvh:1: "));
  EXPECT_THAT(error_of([&] { import_library({folder / "bad.bvh"}, std::nullopt); }),
              HasSubstr("bad.bvh:1: "));
  std::filesystem::create_directory(folder / "empty");
  EXPECT_THAT(error_of([&] { import_library({folder / "empty"}, std::nullopt); }),
              EndsWith("empty: there are no BVH, FBX or glTF files to import"));
}

}  // namespace
}  // namespace flinch::database
