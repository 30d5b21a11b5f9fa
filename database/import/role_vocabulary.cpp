// SPDX-License-Identifier: MIT
#include "database/import/role_vocabulary.h"

#include <array>

namespace flinch::database {
namespace {

using motion::Role;
using enum NameFit;

// Sources, beside the files of the rigs themselves: the tables of rokoko-studio-live-blender
// (core/auto_detect_lists/bones.py) and of expykit; joint_names.py of smplx (SMPL, SMPL-X);
// JointType of Kinect's SDK and k4abt_joint_id_t of Azure Kinect's; the 21 bones of Motive's
// skeletons, as in projectaria_tools (AriaDigitalTwinSkeletonProvider.cpp); DazToUnreal (Genesis 3
// to 9); mmd_tools (MikuMikuDance, Japanese and English); H-Anim (ISO/IEC 19774).
constexpr KnownStem kLimbStems[] = {
    {"clavicle", Role::left_clavicle, exact},
    {"clavic", Role::left_clavicle, exact},
    {"collar", Role::left_clavicle, exact},
    {"collarbone", Role::left_clavicle, exact},
    {"scapula", Role::left_clavicle, exact},
    {"sternoclavicular", Role::left_clavicle, exact},
    {"肩", Role::left_clavicle, exact},
    // the clavicle where another joint is the upper arm (MotionBuilder, Motive, VRM, MMD), else the
    // upper arm (SMPL, Kinect, Xsens, iPi)
    {"shoulder", Role::left_clavicle, likely},
    {"shoulder", Role::left_upper_arm, likely},

    {"upperarm", Role::left_upper_arm, exact},
    {"arm", Role::left_upper_arm, exact},
    {"uparm", Role::left_upper_arm, exact},
    {"uarm", Role::left_upper_arm, exact},
    {"armupper", Role::left_upper_arm, exact},
    {"shldr", Role::left_upper_arm, exact},
    {"humerus", Role::left_upper_arm, exact},
    {"腕", Role::left_upper_arm, exact},
    {"elbow", Role::left_upper_arm, possible},

    {"forearm", Role::left_forearm, exact},
    {"lowerarm", Role::left_forearm, exact},
    {"lowarm", Role::left_forearm, exact},
    {"loarm", Role::left_forearm, exact},
    {"farm", Role::left_forearm, exact},
    {"armlower", Role::left_forearm, exact},
    {"elbow", Role::left_forearm, exact},
    {"radius", Role::left_forearm, exact},
    {"ひじ", Role::left_forearm, exact},
    {"肘", Role::left_forearm, exact},
    {"wrist", Role::left_forearm, possible},

    {"hand", Role::left_hand, exact},
    {"wrist", Role::left_hand, exact},
    {"手首", Role::left_hand, exact},

    {"thigh", Role::left_thigh, exact},
    {"upperleg", Role::left_thigh, exact},
    {"upleg", Role::left_thigh, exact},
    {"uleg", Role::left_thigh, exact},
    {"legupper", Role::left_thigh, exact},
    {"femur", Role::left_thigh, exact},
    {"hip", Role::left_thigh, exact},
    {"足", Role::left_thigh, exact},
    // the thigh in MMD's English names, the shin elsewhere
    {"leg", Role::left_thigh, likely},
    {"knee", Role::left_thigh, possible},

    {"shin", Role::left_shin, exact},
    {"calf", Role::left_shin, exact},
    {"lowerleg", Role::left_shin, exact},
    {"lowleg", Role::left_shin, exact},
    {"loleg", Role::left_shin, exact},
    {"leglower", Role::left_shin, exact},
    {"leg", Role::left_shin, exact},
    {"knee", Role::left_shin, exact},
    {"tibia", Role::left_shin, exact},
    {"shank", Role::left_shin, exact},
    {"ひざ", Role::left_shin, exact},
    {"膝", Role::left_shin, exact},
    {"ankle", Role::left_shin, possible},

    {"foot", Role::left_foot, exact},
    {"ankle", Role::left_foot, exact},
    {"足首", Role::left_foot, exact},
    {"toe", Role::left_foot, possible},

    {"toes", Role::left_toes, exact},
    {"toe", Role::left_toes, exact},
    {"toebase", Role::left_toes, exact},
    {"ball", Role::left_toes, exact},
    {"つま先", Role::left_toes, exact},
    {"足先ex", Role::left_toes, exact},
    // SMPL and Kinect: below the ankle
    {"foot", Role::left_toes, possible},
};

constexpr std::array<std::string_view, 5> kPelvis{"pelvis", "下半身", "hips", "hip", "lowertorso"};
constexpr std::array<std::string_view, 5> kHead{"head", "skull", "face", "頭", "spine006"};
constexpr std::array<std::string_view, 5> kNeck{"neck", "necktwist", "lowerneck", "necklower",
                                                "首"};

// Character Creator; MotionBuilder; 3ds Max Biped; Source's ValveBiped; Rigify; VRoid's VRM;
// Bandai-Namco; Mixamo without its colon.
constexpr std::array<std::string_view, 16> kPrefixes{
    "cc base",    "character1", "valve biped bip01", "bip01", "bip001", "bip",
    "def",        "org",        "j bip c",           "j bip", "joint",  "mixamorig",
    "mixamorig1", "bone",       "k4abt joint",       "jnt"};

constexpr std::array<std::string_view, 29> kHelperWords{"twist",
                                                        "roll",
                                                        "share",
                                                        "metatarsal",
                                                        "metatarsals",
                                                        "metacarpal",
                                                        "carpal",
                                                        "subtalar",
                                                        "midtarsal",
                                                        "transversetarsal",
                                                        "acromioclavicular",
                                                        "end",
                                                        "nub",
                                                        "tip",
                                                        "ik",
                                                        "pole",
                                                        "target",
                                                        "thumb",
                                                        "finger",
                                                        "index",
                                                        "middle",
                                                        "ring",
                                                        "pinky",
                                                        "dummy",
                                                        "helper",
                                                        "捩",
                                                        "手捩",
                                                        "腕捩",
                                                        "先"};

}  // namespace

std::span<const KnownStem> limb_stems() {
  return kLimbStems;
}

std::span<const std::string_view> middle_stems(Role role) {
  switch (role) {
    case Role::pelvis:
      return kPelvis;
    case Role::neck:
      return kNeck;
    case Role::head:
      return kHead;
    default:
      return {};
  }
}

std::span<const std::string_view> rig_prefixes() {
  return kPrefixes;
}

std::span<const std::string_view> helper_words() {
  return kHelperWords;
}

}  // namespace flinch::database
