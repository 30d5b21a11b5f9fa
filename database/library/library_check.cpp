// SPDX-License-Identifier: MIT
#include "database/library/library_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "database/library/library_bounds.h"
#include "database/library/library_file.h"
#include "database/library/text_check.h"
#include "motion/loop.h"
#include "motion/skeleton.h"

namespace flinch::database {
namespace {

using motion::Annotation;
using motion::Clip;
using motion::Pose;

constexpr float kTimeTolerance_s = 1e-4F;
constexpr float kDirectionTolerance = 1e-4F;

/// False for not-a-number.
bool is_in(float number, float min, float max) {
  return number >= min && number <= max;
}

bool is_within(const Eigen::Vector3f& vector, float max) {
  return (vector.array().abs() <= max).all();  // false for not-a-number
}

bool is_direction(float direction) {
  constexpr float kSector = std::numbers::pi_v<float> / 4;
  const float sectors = direction / kSector;
  const float nearest = std::round(sectors);
  return nearest > -4 && nearest <= 4 &&
         std::abs(sectors - nearest) * kSector <= kDirectionTolerance;
}

bool is_text(std::string_view text, std::size_t max_size) {
  return text.size() <= max_size && is_printable(text);
}

bool is_within_bounds(const Pose& pose) {
  return is_sound(pose) && is_within(pose.root_position, kMaxDistance_m);
}

enum class Poses : bool { unchecked, sound };

const char* fault_of(const Clip& clip, float rate_hz, Poses poses) {
  if (const char* what = fault_of_name(clip.name)) return what;
  if (!is_text(clip.kind, kMaxNameSize) || !is_text(clip.mirrored_from, kMaxNameSize) ||
      !is_text(clip.source, kMaxSourceSize)) {
    return "has a kind or source that is too long, not UTF-8 or has control characters";
  }
  if (clip.purpose > motion::Purpose::stance) return "has an unknown purpose";
  if (clip.motion.rate_hz != rate_hz) return "has another rate than its library";
  if (clip.motion.poses.empty()) return "has no poses";
  if (clip.motion.poses.size() > kMaxPoses) return "has more than a million poses";
  if (poses == Poses::unchecked && !std::ranges::all_of(clip.motion.poses, is_within_bounds)) {
    return "has a pose with a number that is not finite, a rotation that is not a unit one or a "
           "root farther than 1 km away";
  }
  if (clip.purpose == motion::Purpose::stance) {
    if (clip.motion.poses.size() < 2) return "is a stance of a single pose";
    if (clip.annotation) return "is a stance and has an annotation";
    const motion::LoopGap gap = motion::loop_gap(clip.motion);
    if (gap.height_m > motion::kMaxLoopGap_m || gap.angle > motion::kMaxLoopGap)
      return "is a stance whose last pose does not continue as its first";
  }
  const float duration_s = clip.motion.duration_s();
  if (clip.annotation) {
    if (const char* what = database::fault_of(*clip.annotation, duration_s)) return what;
  }
  return clip.push ? database::fault_of(*clip.push, duration_s) : nullptr;
}

/// Whether the figure's bodies, whose sizes follow from these lengths, have sizes above 0.
const char* fault_of(const motion::Skeleton& skeleton) {
  using motion::Role;
  const auto is_bone = [](const Eigen::Vector3f& bone) {
    return bone.allFinite() && bone.norm() <= kMaxBone_m;
  };
  if (!std::ranges::all_of(skeleton.tip, is_bone) ||
      !std::all_of(skeleton.offset.begin() + 1, skeleton.offset.end(), is_bone) ||
      !is_within(skeleton.offset[Role::pelvis], kMaxStature_m)) {
    return "the skeleton has a bone that is not finite or longer than 5 m";
  }
  for (const Role role :
       {Role::left_forearm, Role::left_hand, Role::right_forearm, Role::right_hand, Role::left_shin,
        Role::left_foot, Role::right_shin, Role::right_foot}) {
    if (!(skeleton.offset[role].norm() >= kMinLimb_m)) {
      return "the skeleton has an arm or leg shorter than 1 cm";
    }
  }
  const motion::JointFrames rest =
      motion::forward_kinematics(skeleton, motion::rest_pose(skeleton));
  const auto breadth = [&rest](Role left, Role right) {
    return rest.position[left].y() - rest.position[right].y();
  };
  if (!(breadth(Role::left_upper_arm, Role::right_upper_arm) >= kMinBreadth_m) ||
      !(breadth(Role::left_thigh, Role::right_thigh) >= kMinBreadth_m)) {
    return "the skeleton's left shoulder or hip is not to the left of the right one";
  }
  const float stature = rest.position[Role::head].z() + skeleton.tip[Role::head].z();
  return is_in(stature, kMinStature_m, kMaxStature_m)
             ? nullptr
             : "the skeleton is not between 0.2 m and 20 m tall";
}

}  // namespace

const char* fault_of_name(std::string_view name) {
  if (name.empty()) return "has no name";
  return is_text(name, kMaxNameSize)
             ? nullptr
             : "has a name that is longer than 255 bytes, not UTF-8 or has control characters";
}

const char* fault_of(const Annotation& annotation, float duration_s) {
  if (static_cast<int>(annotation.target) >= motion::kTargetCount) return "has an unknown target";
  if (annotation.degree > motion::Degree::exaggerated) return "has an unknown degree";
  if (!is_direction(annotation.direction)) return "has a direction that is not one of the eight";
  const bool in_order =
      annotation.onset_s >= 0 && annotation.peak_s - annotation.onset_s >= kMinRise_s &&
      annotation.peak_s <= annotation.end_s && annotation.end_s <= duration_s + kTimeTolerance_s;
  return in_order ? nullptr
                  : "breaks 0 <= onset < peak <= end <= duration, with 1 ms from onset to peak";
}

const char* fault_of(const motion::Push& push, float duration_s) {
  if (static_cast<int>(push.place) >= motion::kRoleCount || !motion::is_push_place(push.place)) {
    return "has a push at a joint that is not of the upper body";
  }
  if (!(std::abs(push.direction) <= std::numbers::pi_v<float> + kDirectionTolerance)) {
    return "has a push from a direction that is not within half a turn";
  }
  if (!is_within(push.velocity, kMaxPushSpeed_mps)) return "has a push of more than 20 m/s";
  const bool in_order = push.contact_s >= 0 && push.peak_s - push.contact_s >= kMinRise_s &&
                        push.peak_s <= duration_s + kTimeTolerance_s;
  return in_order ? nullptr
                  : "breaks 0 <= contact < peak <= duration, with 1 ms from contact to peak";
}

const char* fault_of(const motion::Physique& character) {
  if (const char* what = fault_of(character.skeleton)) return what;
  if (!is_in(character.mass_kg, kMinMass_kg, kMaxMass_kg)) {
    return "the character's mass is not between 1 kg and 1000 kg";
  }
  if (character.sex > motion::Sex::male) return "the character's sex is unknown";
  return nullptr;
}

namespace {

std::optional<LibraryFault> fault_of(const ClipLibrary& library, Poses poses) {
  const auto whole = [](const char* what) { return LibraryFault{std::nullopt, what}; };
  if (fault_of_name(library.name) != nullptr) {
    return whole(
        "the library has no name, or one that is too long, not UTF-8 or has control "
        "characters");
  }
  if (!is_in(library.rate_hz, kMinRate_hz, kMaxRate_hz)) {
    return whole("the rate is not between 1 Hz and 1000 Hz");
  }
  if (const char* what = database::fault_of(library.character)) return whole(what);
  if (!is_text(library.provenance, kMaxProvenanceSize))
    return whole("the provenance is longer than 1 MiB or has control characters");
  if (library.idle < 0 || static_cast<std::size_t>(library.idle) >= library.clips.size()) {
    return whole("there is no idle clip");
  }
  if (library.clips.size() > kMaxClips) return whole("there are more than 10,000 clips");
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < library.clips.size(); ++i) {
    const Clip& clip = library.clips[i];
    if (const char* what = fault_of(clip, library.rate_hz, poses)) return LibraryFault{i, what};
    if (!names.insert(clip.name).second) return LibraryFault{i, "shares its name with another"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<LibraryFault> fault_of(const ClipLibrary& library) {
  return fault_of(library, Poses::unchecked);
}

std::optional<LibraryFault> fault_beside_poses(const ClipLibrary& library) {
  return fault_of(library, Poses::sound);
}

}  // namespace flinch::database
