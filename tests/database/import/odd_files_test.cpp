// SPDX-License-Identifier: MIT
// A table of small files that go wrong in other readers, where there are any: ../shared/cases/bvh
// beside the checkout. Each holds the same figure of known lengths. Prints for each file whether it
// comes out right, with or without a note, or as it is with a note on what is wrong, or is refused.
// Tests with inputs of their own cover each kind of file: role_map_test, limb_match_test,
// figure_test, up_estimate_test, plausibility_test, bvh_test, and reading_test of the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "database/import/foot_drift.h"
#include "database/import/import.h"
#include "database/import/source_character.h"
#include "motion/error.h"
#include "motion/figure.h"
#include "motion/rotation.h"
#include "tests/database/import/place_deviation.h"

namespace flinch::database {
namespace {

using Eigen::Vector3d;
using motion::Role;

const std::string kCases = std::string(FLINCH_MOCAP_DIR) + "/../cases/bvh/";

// What has to come out.
enum class Verdict : std::uint8_t {
  right,  ///< the right figure and motion, without a note
  noted,  ///< the same with a note on what was guessed
  told,   ///< what the file holds, with a note on what is wrong and the option that mends it
};

struct OddFile {
  const char* name;
  Verdict verdict = Verdict::right;
  const char* note = "";    ///< a part of it
  const char* option = "";  ///< what `options` are on the command line
  SourceOptions options{};
};

SourceOptions with_frames(const FrameOptions& frames) {
  SourceOptions options;
  options.frames = frames;
  return options;
}

SourceOptions with_sides_exchanged() {
  SourceOptions options;
  const Source source = analyse_source(read_bvh(kCases + "left_handed_mirror.bvh"));
  for (Role role : motion::kRoles) {
    options.roles[role] = source.report.joint_name[motion::mirrored(role)];
  }
  return options;
}

// The files, and those with a note once more with the option that it names.
std::vector<OddFile> odd_files() {
  using enum Verdict;
  return {{"base"},
          {"smpl_ankle_and_foot"},
          {"kinect_wrist_and_hand"},
          {"optitrack_motive_names"},
          {"names_at_bone_ends"},
          {"stub_end_sites"},
          {"end_site_points_up"},
          {"toe_joint_on_the_ankle", noted, "not at the ball of the foot"},
          {"fore_foot_below_the_ankle", noted, "not at the ball of the foot"},
          {"offsets_longer_than_positions"},
          {"left_handed_mirror", told, "both feet point backward"},
          {"left_handed_mirror", right, "", "--roles", with_sides_exchanged()},
          {"plank_all_the_time", noted, "up is taken to be y"},
          {"tpose_first_frame", told, "frame 1 is a T-pose, 9.01 m from frame 2"},
          {"tpose_first_frame", right, "", "--skip-first", with_frames({.skip_first = true})},
          {"two_frames_kilometres_away", told, "frames 41 to 42"},
          {"two_frames_kilometres_away", right, "", "--frames 43:90",
           with_frames({.range = FrameRange{43, 90}})},
          {"frame_time_one_second", told, "--rate-of-file"},
          {"frame_time_one_second", right, "", "--rate-of-file 30", with_frames({.rate_hz = 30})},
          {"frames_one_too_few_declared", noted, "90 whole frames"},
          {"frames_one_too_many_declared", noted, "90 whole frames"},
          {"duck_knees_162_degrees"},
          {"positions_relative_to_offset", noted, "are added"},
          {"guard_all_the_time_offsets_along_x", told, "--rest"},
          {"rig_prefix_unknown"},
          {"rig_suffix_jnt"},
          {"genea_b_prefix"},
          {"all_lower_case_run_together"},
          {"daz_genesis_bend_names"},
          {"mmd_japanese_names"},
          {"latin1_joint_name", noted, "Latin-1"},
          {"bom_and_crlf"},
          {"leading_blank_lines"},
          {"comment_lines"},
          {"end_site_with_channels0"},
          {"bow_with_chest_joint_at_the_shoulders"}};
}

// What came out. Lengths are m; the true ones stand beside the bounds in is_right.
struct Outcome {
  std::string refused;  ///< why; empty where it was not
  std::vector<std::string> notes;
  float thigh = 0, shin = 0, ball_forward = 0, ball_down = 0;
  float upper_arm = 0, forearm = 0, hand = 0;
  float half_hips = 0, half_shoulders = 0, stature = 0;
  tests::PlaceDeviation place;  ///< of the motion from the source's, relative to the hips
  float sole_below_ground = 0, added_drift = 0;
  UpAxis up = UpAxis::y;
};

void measure_figure(const motion::Skeleton& figure, Outcome& outcome) {
  const motion::JointFrames rest = forward_kinematics(figure, motion::rest_pose(figure));
  outcome.thigh = figure.offset[Role::left_shin].norm();
  outcome.shin = figure.offset[Role::left_foot].norm();
  outcome.ball_forward = figure.offset[Role::left_toes].x();
  outcome.ball_down = -figure.offset[Role::left_toes].z();
  outcome.upper_arm = figure.offset[Role::left_forearm].norm();
  outcome.forearm = figure.offset[Role::left_hand].norm();
  outcome.hand = figure.tip[Role::left_hand].norm();
  outcome.half_hips = rest.position[Role::left_thigh].y();
  outcome.half_shoulders = rest.position[Role::left_upper_arm].y();
  outcome.stature = motion::stature(figure);
}

Outcome outcome_of(const OddFile& file) {
  Outcome outcome;
  const std::string path = kCases + file.name + ".bvh";
  try {
    const Source source = analyse_source(read_bvh(path), file.options);
    const SourceMotion motion = source_motion(source);
    const motion::Skeleton figure = character_of(source).skeleton;
    const Segment whole{0, motion.duration_s(), 0};
    const motion::Motion clip =
        retarget(motion, figure, whole, static_cast<float>(1 / motion.frame_time_s));
    outcome.notes = inspect_source(path, file.options).warnings;
    outcome.up = source.report.up;
    measure_figure(figure, outcome);
    outcome.place = tests::largest(tests::place_deviations(source, figure, whole, clip));
    const FootDrift drift = measure_foot_drift(motion, figure, whole, clip);
    outcome.sole_below_ground = -drift.lowest_sole_m;
    outcome.added_drift = drift.added_m;
  } catch (const Error& error) {
    outcome.refused = error.what();
  }
  return outcome;
}

bool is_near(float value, float truth, float tolerance) {
  return std::abs(value - truth) <= tolerance;
}

bool is_right(const Outcome& outcome) {
  return outcome.refused.empty() && outcome.up == UpAxis::y &&
         is_near(outcome.thigh, 0.42F, 0.01F) && is_near(outcome.shin, 0.40F, 0.01F) &&
         is_near(outcome.ball_forward, 0.13F, 0.012F) && is_near(outcome.ball_down, 0.05F, 0.02F) &&
         is_near(outcome.upper_arm, 0.28F, 0.01F) && is_near(outcome.forearm, 0.25F, 0.01F) &&
         is_near(outcome.hand, 0.17F, 0.02F) && is_near(outcome.half_hips, 0.09F, 0.01F) &&
         is_near(outcome.half_shoulders, 0.17F, 0.01F) && is_near(outcome.stature, 1.67F, 0.03F) &&
         outcome.place.head <= 0.03F && outcome.place.shoulder <= 0.03F &&
         outcome.place.hand <= 0.03F && outcome.sole_below_ground <= 0.012F &&
         outcome.added_drift <= 0.01F;
}

bool has_note(const Outcome& outcome, const std::string& part) {
  return std::ranges::any_of(
      outcome.notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

// What came out of what has to.
std::string verdict_on(const OddFile& file, const Outcome& outcome) {
  if (!outcome.refused.empty()) return "refused";
  const bool is_noted = has_note(outcome, file.note);
  switch (file.verdict) {
    case Verdict::right:
      return is_right(outcome) && outcome.notes.empty() ? "right" : "WRONG";
    case Verdict::noted:
      return is_right(outcome) && is_noted ? "right, noted" : "WRONG";
    case Verdict::told:
      break;
  }
  return is_noted ? "told" : "WRONG";
}

std::string first_message(const Outcome& outcome) {
  std::string message = outcome.refused;
  if (message.empty() && !outcome.notes.empty()) message = outcome.notes.front();
  if (message.starts_with(kCases)) message.erase(0, kCases.size());
  return message;
}

void print_row(const OddFile& file, const Outcome& outcome) {
  const auto mm = [](float metres) { return static_cast<double>(1000 * metres); };
  const std::string name = std::string(file.name) + " " + file.option;
  std::printf("%-44s %-12s", name.c_str(), verdict_on(file, outcome).c_str());
  for (float length :
       {outcome.thigh, outcome.shin, outcome.ball_forward, outcome.ball_down, outcome.upper_arm,
        outcome.forearm, outcome.hand, outcome.half_hips, outcome.half_shoulders, outcome.stature,
        outcome.place.head, outcome.place.hand, std::max(0.0F, outcome.sole_below_ground),
        outcome.added_drift}) {
    std::printf(" %5.0f", mm(length));
  }
  std::printf("  %s\n", first_message(outcome).c_str());
}

TEST(OddFiles, ComeOutRightOrAreTold) {
  if (!std::filesystem::exists(kCases)) GTEST_SKIP() << "there are no cases in " << kCases;
  std::printf("%-44s %-12s", "file, lengths in mm", "result");
  for (const char* title : {"thigh", "shin", "ball", "down", "upper", "fore", "hand", "hips",
                            "shldr", "tall", "dhead", "dhand", "sole", "drift"}) {
    std::printf(" %5s", title);
  }
  std::printf("  first note\n");
  for (const OddFile& file : odd_files()) {
    const Outcome outcome = outcome_of(file);
    print_row(file, outcome);
    EXPECT_THAT(verdict_on(file, outcome), testing::AnyOf("right", "right, noted", "told"))
        << file.name;
  }
}

// Every file of the folder has its row.
TEST(OddFiles, AreAllInTheTable) {
  if (!std::filesystem::exists(kCases)) GTEST_SKIP() << "there are no cases in " << kCases;
  std::vector<std::string> names;
  for (const OddFile& file : odd_files()) names.emplace_back(file.name);
  for (const auto& entry : std::filesystem::directory_iterator(kCases)) {
    if (entry.path().extension() != ".bvh") continue;
    EXPECT_THAT(names, testing::Contains(entry.path().stem().string()));
  }
}

}  // namespace
}  // namespace flinch::database
