// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numbers>

#include "database/import/import.h"
#include "database/import/retarget.h"
#include "database/import/source_character.h"
#include "motion/error.h"
#include "motion/limb_ik.h"
#include "tests/database/import/place_deviation.h"

namespace flinch::database {
namespace {

using Eigen::Vector3f;
using motion::Clip;
using motion::JointFrames;
using motion::Limb;
using motion::Role;

const std::string kMocap = FLINCH_MOCAP_DIR;

const ImportResult& imported() {
  static const ImportResult kResult = import_library({kMocap}, kMocap + "/manifest.toml");
  return kResult;
}

class Mocap : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kMocap + "/manifest.toml")) {
      GTEST_SKIP() << "there is no motion capture in " << kMocap;
    }
  }
};

std::vector<const Clip*> clips_where(const std::string& kind) {
  std::vector<const Clip*> found;
  for (const Clip& clip : imported().library.clips) {
    if (clip.kind == kind && clip.annotation && clip.mirrored_from.empty()) found.push_back(&clip);
  }
  return found;
}

JointFrames frames_at(const Clip& clip, float time_s) {
  return forward_kinematics(imported().library.character.skeleton, sample(clip.motion, time_s));
}

std::vector<JointFrames> all_frames(const Clip& clip) {
  std::vector<JointFrames> frames;
  for (const motion::Pose& pose : clip.motion.poses) {
    frames.push_back(forward_kinematics(imported().library.character.skeleton, pose));
  }
  return frames;
}

float head_height(const JointFrames& frames) {
  return frames.position[Role::head].z();
}

TEST_F(Mocap, TheWholeManifestBecomesALibrary) {
  std::map<std::string, int> count;
  for (const Clip& clip : imported().library.clips) {
    ++count[clip.mirrored_from.empty() ? std::string(name_of(clip.purpose)) : "mirrored"];
  }
  EXPECT_EQ(count["anticipation"], 66);
  EXPECT_EQ(count["mirrored"], 66 + 29);
  EXPECT_EQ(count["idle"], 3);
  EXPECT_EQ(count["push"], 29);
  EXPECT_EQ(imported().library.idle_clip().name, "idle_65");
  EXPECT_TRUE(imported().report.skipped.empty());
}

// One is in a unit that is none of those known; in the other the left wrist is turned by a quarter.
TEST_F(Mocap, AtMostTwoFilesGetANote) {
  std::map<std::string, std::string> notes;
  for (const SourceReport& source : imported().report.sources) {
    for (const std::string& note : source.warnings) {
      notes[std::filesystem::path(source.path).filename()] += note + '\n';
    }
  }
  for (const ClipReport& clip : imported().report.clips) {
    for (const std::string& note : clip.warnings) {
      notes[std::filesystem::path(clip.source).filename()] += note + '\n';
    }
  }
  EXPECT_EQ(imported().report.sources.size(), 44U);
  EXPECT_LE(notes.size(), 2U) << testing::PrintToString(notes);
}

// The folders' descriptions say which files begin with a T-pose.
TEST_F(Mocap, TPosesInFrontAreToldAndNothingElse) {
  const auto told = [](const std::string& file) {
    return testing::PrintToString(inspect_source(kMocap + "/" + file).warnings);
  };
  for (const char* file : {"cmu_motionbuilder/02_04.bvh", "cmu_daz/13_39.bvh",
                           "snu_boxing/ducking_dir_f0000-0909.bvh"}) {
    EXPECT_THAT(told(file), testing::HasSubstr("a T-pose")) << file;
  }
  for (const char* file : {"snu_boxing/block_01_left_arm_high.bvh",
                           "bandai/dataset-2_raise-up-both-hands_active_001.bvh",
                           "deepmimic/humanoid3d_roll.bvh", "snu_push/PushStep00.bvh"}) {
    EXPECT_EQ(told(file), "{}") << file;
  }
}

TEST_F(Mocap, TheCharacterIsAnAdultOfHumanProportions) {
  const motion::Physique& character = imported().library.character;
  const JointFrames rest =
      forward_kinematics(character.skeleton, motion::rest_pose(character.skeleton));
  const float stature = rest.position[Role::head].z() + character.skeleton.tip[Role::head].z();
  EXPECT_GT(stature, 1.65F);
  EXPECT_LT(stature, 1.85F);
  EXPECT_NEAR(character.mass_kg, 23 * stature * stature, 0.01F);
  // Drillis and Contini (1966): hip at 0.530 and knee at 0.285 of the stature, shoulder at 0.818.
  EXPECT_NEAR(rest.position[Role::left_thigh].z() / stature, 0.530F, 0.03F);
  EXPECT_NEAR(rest.position[Role::left_shin].z() / stature, 0.285F, 0.02F);
  EXPECT_NEAR(rest.position[Role::left_upper_arm].z() / stature, 0.818F, 0.03F);
}

// Joint names for the roles according to the folders' own descriptions.
struct FolderRoles {
  const char* file;
  const char* unit;
  const char* up;
  std::map<Role, std::string> joints;
};

TEST_F(Mocap, EveryFoldersSkeletonIsMappedAsItsDescriptionSays) {
  const std::map<Role, std::string> snu{{Role::pelvis, "Hips"},
                                        {Role::abdomen, "Spine"},
                                        {Role::chest, "Spine1"},
                                        {Role::neck, ""},
                                        {Role::head, "Head"},
                                        {Role::left_clavicle, "LeftShoulder1"},
                                        {Role::right_clavicle, "RightShoulder"},
                                        {Role::left_upper_arm, "LeftArm"},
                                        {Role::left_forearm, "LeftForeArm"},
                                        {Role::left_hand, "LeftHand"},
                                        {Role::left_thigh, "LeftUpLeg"},
                                        {Role::left_shin, "LeftLeg"},
                                        {Role::left_foot, "LeftFoot"},
                                        {Role::left_toes, "LeftToes"}};
  const FolderRoles folders[] = {
      {"snu_boxing/block_01_left_arm_high.bvh", "inch", "y", snu},
      {"snu_balance/tt_sidestep_1.bvh", "inch", "y", snu},
      {"snu_balance/falling_down.bvh", "cm", "y", snu},
      {"snu_push/push_fwd_step_01.bvh", "cm", "y", snu},
      {"cmu_daz/10_03.bvh",
       "cm",
       "y",
       {{Role::pelvis, "hip"},
        {Role::abdomen, "abdomen"},
        {Role::chest, "chest"},
        {Role::neck, "neck"},
        {Role::head, "head"},
        {Role::left_clavicle, "lCollar"},
        {Role::left_upper_arm, "lShldr"},
        {Role::left_forearm, "lForeArm"},
        {Role::left_hand, "lHand"},
        {Role::left_thigh, "lThigh"},
        {Role::left_shin, "lShin"},
        {Role::left_foot, "lFoot"},
        {Role::left_toes, ""}}},
      {"cmu_motionbuilder/02_04.bvh",
       "cmu",
       "y",
       {{Role::pelvis, "Hips"},
        {Role::abdomen, "Spine"},
        {Role::chest, "Spine1"},
        {Role::neck, "Neck1"},
        {Role::head, "Head"},
        {Role::right_clavicle, "RightShoulder"},
        {Role::right_upper_arm, "RightArm"},
        {Role::right_thigh, "RightUpLeg"},
        {Role::right_shin, "RightLeg"},
        {Role::right_toes, "RightToeBase"}}},
      {"cmu_iclone/002_04.bvh",
       "cm",
       "y",
       {{Role::pelvis, "CC_Base_Pelvis"},
        {Role::abdomen, "CC_Base_Waist"},
        {Role::chest, "CC_Base_Spine02"},
        {Role::neck, "CC_Base_NeckTwist01"},
        {Role::head, "CC_Base_Head"},
        {Role::left_clavicle, "CC_Base_L_Clavicle"},
        {Role::left_upper_arm, "CC_Base_L_Upperarm"},
        {Role::left_forearm, "CC_Base_L_Forearm"},
        {Role::left_thigh, "CC_Base_L_Thigh"},
        {Role::left_shin, "CC_Base_L_Calf"},
        {Role::left_toes, "CC_Base_L_ToeBase"}}},
      {"cmu_max/131_01.bvh",
       "cmu",
       "y",
       {{Role::left_clavicle, "LeftCollar"},
        {Role::left_upper_arm, "LeftShoulder"},
        {Role::left_forearm, "LeftElbow"},
        {Role::left_hand, "LeftWrist"},
        {Role::left_thigh, "LeftHip"},
        {Role::left_shin, "LeftKnee"},
        {Role::left_foot, "LeftAnkle"},
        {Role::left_toes, "LeftToe"}}},
      {"bandai/dataset-1_punch_normal_001.bvh",
       "cm",
       "y",
       {{Role::pelvis, "Hips"},
        {Role::abdomen, "Spine"},
        {Role::chest, "Chest"},
        {Role::neck, "Neck"},
        {Role::left_clavicle, "Shoulder_L"},
        {Role::left_upper_arm, "UpperArm_L"},
        {Role::right_toes, "Toes_R"}}},
      {"deepmimic/humanoid3d_kick.bvh",
       "m",
       "y",
       {{Role::pelvis, "root"},
        {Role::abdomen, ""},
        {Role::chest, "chest"},
        {Role::neck, ""},
        {Role::head, "neck"},
        {Role::left_clavicle, ""},
        {Role::left_upper_arm, "left_shoulder"},
        {Role::left_forearm, "left_elbow"},
        {Role::left_hand, ""},
        {Role::left_foot, "left_ankle"},
        {Role::left_toes, ""}}},
      {"animated_drawings/jumping.bvh",
       "inch",
       "z",
       {{Role::pelvis, "Hips"},
        {Role::chest, "Spine3"},
        {Role::neck, "Neck"},
        {Role::left_clavicle, "LeftShoulder"},
        {Role::left_upper_arm, "LeftArm"}}},
      {"reactidle/003_genuine_f000-479.bvh",
       "m",
       "y",
       {{Role::pelvis, "pelvis"},
        {Role::abdomen, "spine"},
        {Role::chest, "spine.001"},
        {Role::neck, "neck"},
        {Role::head, "face"},
        {Role::left_clavicle, "shoulder.L"},
        {Role::left_hand, ""},
        {Role::left_thigh, "thigh.L"}}},
      {"odd/mixamorig_names_zyx.bvh",
       "cm",
       "y",
       {{Role::pelvis, "mixamorig:Hips"},
        {Role::abdomen, "mixamorig:Spine"},
        {Role::chest, "mixamorig:Spine2"},
        {Role::left_toes, "mixamorig:LeftToeBase"}}},
  };
  for (const FolderRoles& folder : folders) {
    const SourceReport report = inspect_source(kMocap + "/" + folder.file);
    EXPECT_EQ(name_of(report.unit), folder.unit) << folder.file;
    EXPECT_EQ(name_of(report.up), folder.up) << folder.file;
    for (const auto& [role, joint] : folder.joints) {
      EXPECT_EQ(report.joint_name[role], joint) << folder.file << ", " << motion::name_of(role);
    }
  }
}

TEST_F(Mocap, RetargetingAddsAtMostOneCentimetreOfFootDrift) {
  float planted_s = 0;
  std::printf("%-26s %9s %11s %10s %10s\n", "clip", "planted_s", "source_mm", "added_mm",
              "lowest_mm");
  for (const ClipReport& clip : imported().report.clips) {
    const FootDrift& drift = clip.drift;
    std::printf("%-26s %9.2f %11.1f %10.2f %10.1f\n", clip.name.c_str(), drift.planted_s,
                drift.source_m * 1e3F, drift.added_m * 1e3F, drift.lowest_sole_m * 1e3F);
    EXPECT_LE(drift.added_m, 0.010F) << clip.name;
    // The roll turns the feet so that bending the toes cannot keep them above the ground.
    const float deepest = clip.name == "dodge_high_back_1" ? -0.04F : -0.012F;
    EXPECT_GE(drift.lowest_sole_m, deepest) << clip.name;
    planted_s += drift.planted_s;
  }
  EXPECT_GT(planted_s, 400);  // so that the bound above covers a real amount
}

// Each file with a character of its own, so that both have the same size.
TEST_F(Mocap, HeadShouldersAndHandsStayWhereTheSourceHasThem) {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kMocap)) {
    const std::string path = entry.path().string();
    // odd/ holds files to break parsers, and figures that are not human.
    if (entry.path().extension() != ".bvh" || path.find("/odd/") != std::string::npos) continue;
    const Source source = analyse_source(read_bvh(path));
    const SourceMotion motion = source_motion(source);
    const motion::Skeleton skeleton = character_of(source).skeleton;
    const Segment whole{0, motion.duration_s(), 0};
    const motion::Motion clip =
        retarget(motion, skeleton, whole, static_cast<float>(1 / motion.frame_time_s));
    const tests::PlaceDeviation deviation =
        tests::largest(tests::place_deviations(source, skeleton, whole, clip));
    EXPECT_LT(deviation.head, 0.03F) << path;
    EXPECT_LT(deviation.shoulder, 0.03F) << path;
    EXPECT_LT(deviation.hand, 0.03F) << path;
    ++count;
  }
  EXPECT_GT(count, 50);
}

TEST_F(Mocap, ClipsStartAtTheOriginFacingForward) {
  for (const Clip& clip : imported().library.clips) {
    const JointFrames frames = frames_at(clip, 0);
    EXPECT_LT(frames.position[Role::pelvis].head<2>().norm(), 1e-4F) << clip.name;
    // A boxer's pelvis is turned up to 45 degrees from the direction of view.
    EXPECT_LT(std::abs(facing(clip.motion.poses.front())), 1.0F) << clip.name;
  }
}

TEST_F(Mocap, KneesAndElbowsOnlyBendTheWayTheyCan) {
  for (const Clip& clip : imported().library.clips) {
    for (const motion::Pose& pose : clip.motion.poses) {
      for (Limb limb : motion::kLimbs) {
        const Eigen::AngleAxisf bend(pose.rotation[motion::roles_of(limb).lower]);
        const float along = bend.angle() * bend.axis().dot(motion::hinge_axis(limb));
        EXPECT_GE(along, 0) << clip.name;
        EXPECT_NEAR(along, bend.angle(), 2e-3F) << clip.name;
      }
    }
  }
}

TEST_F(Mocap, KneesPointForwardAndHeadsAreUpWhileStanding) {
  for (const Clip& clip : imported().library.clips) {
    if (clip.purpose == motion::Purpose::anticipation) continue;
    const std::vector<JointFrames> all = all_frames(clip);
    float head_up = 0;
    for (const JointFrames& frames : all) {
      head_up +=
          (frames.orientation[Role::head] * Vector3f::UnitZ()).z() / static_cast<float>(all.size());
      EXPECT_GT(frames.position[Role::head].z(), frames.position[Role::chest].z()) << clip.name;
      for (Limb leg : {Limb::left_leg, Limb::right_leg}) {
        const Vector3f knee = motion::pole_vector(frames, leg);
        const Vector3f forward = frames.orientation[Role::pelvis] * Vector3f::UnitX();
        EXPECT_GT(knee.dot(forward), 0.2F) << clip.name;
      }
    }
    EXPECT_GT(head_up, 0.85F) << clip.name;
  }
}

TEST_F(Mocap, DucksLowerTheHeadAsFarAsTheirDegreeSays) {
  const std::vector<const Clip*> ducks = clips_where("duck");
  EXPECT_EQ(ducks.size(), 13U);
  for (const Clip* clip : ducks) {
    const float standing = head_height(frames_at(*clip, 0));
    const float lowest = head_height(frames_at(*clip, clip->annotation->peak_s));
    const bool far = clip->annotation->degree == motion::Degree::exaggerated;
    EXPECT_GT((standing - lowest) / standing, far ? 0.20F : 0.05F) << clip->name;
  }
}

TEST_F(Mocap, StepsGoAwayFromTheThreat) {
  const std::vector<const Clip*> steps = clips_where("step");
  EXPECT_EQ(steps.size(), 7U);
  for (const Clip* clip : steps) {
    const Vector3f way = frames_at(*clip, clip->annotation->peak_s).position[Role::pelvis] -
                         frames_at(*clip, clip->annotation->onset_s).position[Role::pelvis];
    const float direction = clip->annotation->direction;
    const float towards = way.x() * std::cos(direction) + way.y() * std::sin(direction);
    EXPECT_LT(towards, -0.15F) << clip->name;
    EXPECT_LT(towards, -0.8F * way.head<2>().norm()) << clip->name;
  }
}

TEST_F(Mocap, BlocksOfTheHeadBringAHandToIt) {
  int count = 0;
  for (const Clip* clip : clips_where("block")) {
    if (clip->annotation->target != motion::Target::head) continue;
    ++count;
    const JointFrames frames = frames_at(*clip, clip->annotation->peak_s);
    const float hand =
        std::max(frames.position[Role::left_hand].z(), frames.position[Role::right_hand].z());
    const float shoulder = std::max(frames.position[Role::left_upper_arm].z(),
                                    frames.position[Role::right_upper_arm].z());
    EXPECT_GT(hand, shoulder) << clip->name;
  }
  EXPECT_GE(count, 15);
}

TEST_F(Mocap, LegLiftClipsRaiseAFoot) {
  for (const Clip* clip : clips_where("lift")) {
    float highest = 0;
    for (const JointFrames& frames : all_frames(*clip)) {
      highest = std::max(
          {highest, frames.position[Role::left_foot].z(), frames.position[Role::right_foot].z()});
    }
    EXPECT_GT(highest, 0.25F) << clip->name;
  }
}

// One take that came through two converters, on two skeletons, at two rates.
TEST_F(Mocap, DifferentConversionsOfOneTakeAgree) {
  const motion::Skeleton& skeleton = imported().library.character.skeleton;
  const auto retargeted = [&](const std::string& file) {
    const SourceMotion source = source_motion(analyse_source(read_bvh(kMocap + "/" + file)));
    return retarget(source, skeleton, {0.1, 3.9, 0}, 60);
  };
  const motion::Motion one = retargeted("cmu_motionbuilder/02_04.bvh");
  const motion::Motion other = retargeted("cmu_iclone/002_04.bvh");
  ASSERT_EQ(one.poses.size(), other.poses.size());
  double sum_m = 0;
  double largest_m = 0;
  for (std::size_t k = 0; k < one.poses.size(); ++k) {
    const JointFrames a = forward_kinematics(skeleton, one.poses[k]);
    const JointFrames b = forward_kinematics(skeleton, other.poses[k]);
    for (Role role : motion::kRoles) {
      const double distance = (a.position[role] - b.position[role]).norm();
      sum_m += distance / motion::kRoleCount / static_cast<double>(one.poses.size());
      largest_m = std::max(largest_m, distance);
    }
  }
  std::printf("mean distance of joints %.1f mm, largest %.1f mm\n", sum_m * 1e3, largest_m * 1e3);
  EXPECT_LT(sum_m, 0.04);
}

TEST_F(Mocap, FilesThatAreNotHumanAreRefused) {
  for (const char* file : {"odd/single_joint.bvh", "odd/leaf_without_endsite_4_joints.bvh"}) {
    EXPECT_THROW(inspect_source(kMocap + "/" + file), Error) << file;
  }
}

}  // namespace
}  // namespace flinch::database
