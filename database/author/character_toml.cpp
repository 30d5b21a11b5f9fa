// SPDX-License-Identifier: MIT
#include "database/author/character_toml.h"

#include <array>
#include <cmath>
#include <utility>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "database/files/library_writer.h"
#include "database/files/toml_reader.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "motion/foot.h"

namespace flinch::database {
namespace {

using motion::Role;
using motion::Skeleton;

struct NamedProportion {
  std::string_view name;
  float Proportions::*factor;
};
constexpr std::array<NamedProportion, 9> kProportions{{{"legs", &Proportions::legs},
                                                       {"arms", &Proportions::arms},
                                                       {"trunk", &Proportions::trunk},
                                                       {"neck", &Proportions::neck},
                                                       {"head", &Proportions::head},
                                                       {"hands", &Proportions::hands},
                                                       {"feet", &Proportions::feet},
                                                       {"shoulders", &Proportions::shoulders},
                                                       {"hips", &Proportions::hips}}};

struct Range {
  float min, max;
};
constexpr Range kHeight{0.9F, 2.5F};
constexpr Range kMassIndex{10, 60};  // kg/m^2
constexpr Range kProportion{0.6F, 1.6F};

bool is_in(float value, const Range& range) {
  return value >= range.min && value <= range.max;  // false for NaN
}

std::string shown(float value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

void check(bool possible, const std::string& where, std::string_view name, float value,
           const Range& range) {
  if (possible) return;
  throw Error(where, std::string(name) + " " + shown(value) +
                         " is outside the range of people: give one from " + shown(range.min) +
                         " to " + shown(range.max));
}

void scale(Skeleton& skeleton, Role role, float factor) {
  skeleton.offset[role] *= factor;
}

// Offsets come first, then tips: except at the ends of chains, a tip is the next joint's offset.
Skeleton shaped(Skeleton skeleton, const Proportions& proportions) {
  scale(skeleton, Role::abdomen, proportions.trunk);
  scale(skeleton, Role::chest, proportions.trunk);
  scale(skeleton, Role::neck, proportions.trunk);
  scale(skeleton, Role::head, proportions.neck);
  skeleton.tip[Role::head] *= proportions.head;
  for (Role left : {Role::left_clavicle, Role::left_upper_arm, Role::left_forearm, Role::left_hand,
                    Role::left_thigh, Role::left_shin, Role::left_foot, Role::left_toes}) {
    for (Role role : {left, motion::mirrored(left)}) {
      Eigen::Vector3f& offset = skeleton.offset[role];
      if (left == Role::left_clavicle) {
        offset.y() *= proportions.shoulders;
        offset.z() *= proportions.trunk;
      } else if (left == Role::left_upper_arm) {
        offset.y() *= proportions.shoulders;
      } else if (left == Role::left_forearm || left == Role::left_hand) {
        offset *= proportions.arms;
      } else if (left == Role::left_thigh) {
        offset.y() *= proportions.hips;
      } else if (left == Role::left_shin || left == Role::left_foot) {
        offset *= proportions.legs;
      } else {
        offset *= proportions.feet;
      }
    }
  }
  for (Role hand : {Role::left_hand, Role::right_hand}) skeleton.tip[hand] *= proportions.hands;
  for (Role toes : {Role::left_toes, Role::right_toes}) skeleton.tip[toes] *= proportions.feet;
  return skeleton;
}

// Sets the far end of each segment that another segment follows.
void set_tips(Skeleton& skeleton) {
  for (auto [role, next] : {std::pair{Role::pelvis, Role::abdomen},
                            {Role::abdomen, Role::chest},
                            {Role::chest, Role::neck},
                            {Role::neck, Role::head},
                            {Role::left_clavicle, Role::left_upper_arm},
                            {Role::left_upper_arm, Role::left_forearm},
                            {Role::left_forearm, Role::left_hand},
                            {Role::left_thigh, Role::left_shin},
                            {Role::left_shin, Role::left_foot},
                            {Role::left_foot, Role::left_toes}}) {
    skeleton.tip[role] = skeleton.offset[next];
    skeleton.tip[motion::mirrored(role)] = skeleton.offset[motion::mirrored(next)];
  }
}

float crown_height(const Skeleton& skeleton) {
  const motion::JointFrames rest =
      motion::forward_kinematics(skeleton, motion::rest_pose(skeleton));
  return rest.position[Role::head].z() + skeleton.tip[Role::head].z();
}

// The ankle's height above the sole scales with the feet.
void stand_on_ground(Skeleton& skeleton, float ankle_height_m) {
  float below_pelvis = 0;
  for (Role role : {Role::left_thigh, Role::left_shin, Role::left_foot}) {
    below_pelvis += skeleton.offset[role].z();
  }
  skeleton.offset[Role::pelvis].z() = ankle_height_m - below_pelvis;
}

}  // namespace

motion::Physique make_character(float height_m, float mass_kg, motion::Sex sex,
                                const Proportions& proportions, const std::string& where) {
  check(is_in(height_m, kHeight), where, "height_m", height_m, kHeight);
  const float square = height_m * height_m;
  const Range masses{kMassIndex.min * square, kMassIndex.max * square};
  check(is_in(mass_kg, masses), where, "mass_kg", mass_kg, masses);
  for (const NamedProportion& named : kProportions) {
    const float factor = proportions.*named.factor;
    check(is_in(factor, kProportion), where, named.name, factor, kProportion);
  }
  const motion::Physique mean = motion::default_character();
  motion::Physique character{shaped(mean.skeleton, proportions), mass_kg, sex};
  Skeleton& skeleton = character.skeleton;
  const float mean_ankle = motion::measure_foot(mean.skeleton, motion::Side::left).ankle_height;
  stand_on_ground(skeleton, proportions.feet * mean_ankle);
  const float factor = height_m / crown_height(skeleton);
  for (Eigen::Vector3f& offset : skeleton.offset) offset *= factor;
  for (Eigen::Vector3f& tip : skeleton.tip) tip *= factor;
  set_tips(skeleton);
  return character;
}

// Of a mean man's lengths: hips to neck 5.52 units, neck to crown 2.45, upper arm and forearm 3.35
// + 2.96, hand 1.4, half the distance of the shoulders 2.
motion::Physique waist_up_man() {
  return make_character(1.75F, 75, motion::Sex::male,
                        {.arms = 1.127F,
                         .trunk = 1.039F,
                         .neck = 0.922F,
                         .head = 0.922F,
                         .hands = 0.732F,
                         .shoulders = 1.129F});
}

motion::Physique read_character(const std::string& path) {
  const toml::table table = read_toml(path);
  const TomlReader reader(table, path, "the character");
  reader.expect_keys({"height_m", "mass_kg", "sex", "proportions"});
  const motion::Physique mean = motion::default_character();
  motion::Sex sex = mean.sex;
  if (const std::optional<std::string> name = reader.text("sex")) {
    const std::optional<motion::Sex> known = motion::sex_named(*name);
    if (!known) reader.fail("sex", "has an unknown sex \"" + *name + "\"; known are: female, male");
    sex = *known;
  }
  Proportions proportions;
  if (reader.has("proportions")) {
    const toml::table* factors = table["proportions"].as_table();
    if (factors == nullptr) reader.fail("proportions", "needs [proportions] to be a table");
    const TomlReader inner(*factors, path, "[proportions]");
    inner.expect_keys(
        {"legs", "arms", "trunk", "neck", "head", "hands", "feet", "shoulders", "hips"});
    for (const NamedProportion& named : kProportions) {
      const auto factor = inner.number(named.name);
      if (!factor) continue;
      proportions.*named.factor = static_cast<float>(*factor);
      check(is_in(proportions.*named.factor, kProportion), inner.where(named.name), named.name,
            proportions.*named.factor, kProportion);
    }
  }
  // The default mass for another height keeps the mean man's body mass index.
  const float mean_height = crown_height(mean.skeleton);
  const auto height = static_cast<float>(reader.number("height_m").value_or(mean_height));
  const float share = height / mean_height;
  const auto mass =
      static_cast<float>(reader.number("mass_kg").value_or(mean.mass_kg * share * share));
  const std::string where = reader.where(is_in(height, kHeight) ? "mass_kg" : "height_m");
  return make_character(height, mass, sex, proportions, where);
}

motion::Physique find_character(const std::string& path) {
  if (path == kWaistUpMan) return waist_up_man();
  if (file_kind_of(read_file_start(path, kFileOpening)) == FileKind::library)
    return load_library(path).character;
  return read_character(path);
}

}  // namespace flinch::database
