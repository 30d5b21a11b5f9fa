// SPDX-License-Identifier: MIT
#include "database/import/role_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace flinch::database {
namespace {

using motion::Role;

// Prefixes that rigs put before every name, as lower-case words: Character Creator; MotionBuilder;
// 3ds Max Biped; Rigify; VRoid's VRM; Bandai-Namco; Mixamo without its colon.
constexpr std::array<std::string_view, 14> kPrefixes{
    "cc base", "character1", "bip01", "bip001", "bip",       "def",        "org",
    "j bip c", "j bip",      "joint", "jnt",    "mixamorig", "mixamorig1", "bone"};

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool is_upper(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}

bool is_lower(char c) {
  return std::islower(static_cast<unsigned char>(c)) != 0;
}

// A word ends at a separator, and where a lower-case letter or a capitalised word begins a new one:
// "lShldr" is l, shldr; "LHipJoint" is l, hip, joint. Digits belong to the word before them.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (c == ' ' || c == '_' || c == '.' || c == '-' || c == '\t') {
      words.emplace_back();
      continue;
    }
    const bool after_small = i > 0 && is_upper(c) && !is_upper(name[i - 1]);
    const bool before_small = i > 0 && i + 1 < name.size() && is_upper(c) &&
                              is_upper(name[i - 1]) && is_lower(name[i + 1]);
    if (after_small || before_small) words.emplace_back();
    words.back().push_back(lower(c));
  }
  std::erase(words, std::string());
  return words;
}

std::string_view without_namespace(std::string_view name) {
  const std::size_t colon = name.find_last_of(":|");
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

void strip_prefix(std::vector<std::string>& words) {
  for (std::string_view prefix : kPrefixes) {
    const std::vector<std::string> expected = words_of(prefix);
    if (words.size() > expected.size() &&
        std::equal(expected.begin(), expected.end(), words.begin())) {
      words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(expected.size()));
      return;
    }
  }
}

NameSide side_named(std::string_view word) {
  if (word == "l" || word == "left") return NameSide::left;
  if (word == "r" || word == "right") return NameSide::right;
  return NameSide::none;
}

using Stems = std::span<const std::string_view>;

constexpr std::array<std::string_view, 4> kPelvis{"pelvis", "hips", "hip", "lowertorso"};
constexpr std::array<std::string_view, 5> kHead{"head", "skull", "face", "head1", "spine006"};
constexpr std::array<std::string_view, 6> kNeck{"neck",    "neck1",       "neck01",
                                                "neck001", "necktwist01", "lowerneck"};
constexpr std::array<std::string_view, 6> kClavicle{"clavicle", "collar",    "collarbone",
                                                    "shoulder", "shoulder1", "clavicle01"};
constexpr std::array<std::string_view, 7> kUpperArm{"upperarm",   "arm",     "uparm",   "shldr",
                                                    "upperarm01", "humerus", "shoulder"};
constexpr std::array<std::string_view, 6> kForearm{"forearm", "lowerarm",   "lowarm",
                                                   "elbow",   "lowerarm01", "radius"};
constexpr std::array<std::string_view, 2> kHand{"hand", "wrist"};
constexpr std::array<std::string_view, 6> kThigh{"thigh", "upperleg",   "upleg",
                                                 "femur", "upperleg01", "hip"};
constexpr std::array<std::string_view, 8> kShin{"shin", "calf",  "lowerleg",   "lowleg",
                                                "knee", "tibia", "lowerleg01", "leg"};
constexpr std::array<std::string_view, 2> kFoot{"foot", "ankle"};
constexpr std::array<std::string_view, 5> kToes{"toes", "toebase", "toe", "ball", "toe0"};

}  // namespace

PlainName plain_name(std::string_view name) {
  std::vector<std::string> words = words_of(without_namespace(name));
  strip_prefix(words);
  PlainName result;
  if (words.size() > 1) {
    if (side_named(words.front()) != NameSide::none) {
      result.side = side_named(words.front());
      words.erase(words.begin());
    } else if (side_named(words.back()) != NameSide::none) {
      result.side = side_named(words.back());
      words.pop_back();
    }
  }
  for (const std::string& word : words) result.stem += word;
  return result;
}

NameSide side_of(Role role) {
  if (motion::mirrored(role) == role) return NameSide::none;
  return motion::name_of(role).starts_with("left") ? NameSide::left : NameSide::right;
}

Stems stems_of(Role role) {
  switch (role) {
    case Role::pelvis:
      return kPelvis;
    case Role::abdomen:
    case Role::chest:
      return {};  // their number and names vary: found by topology
    case Role::neck:
      return kNeck;
    case Role::head:
      return kHead;
    case Role::left_clavicle:
    case Role::right_clavicle:
      return kClavicle;
    case Role::left_upper_arm:
    case Role::right_upper_arm:
      return kUpperArm;
    case Role::left_forearm:
    case Role::right_forearm:
      return kForearm;
    case Role::left_hand:
    case Role::right_hand:
      return kHand;
    case Role::left_thigh:
    case Role::right_thigh:
      return kThigh;
    case Role::left_shin:
    case Role::right_shin:
      return kShin;
    case Role::left_foot:
    case Role::right_foot:
      return kFoot;
    case Role::left_toes:
    case Role::right_toes:
      return kToes;
  }
  return {};
}

}  // namespace flinch::database
