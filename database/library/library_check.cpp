// SPDX-License-Identifier: MIT
#include "database/library/library_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "database/library/library_file.h"

namespace flinch::database {
namespace {

using motion::Annotation;
using motion::Clip;
using motion::Pose;

constexpr float kTimeTolerance_s = 1e-4F;
constexpr float kDirectionTolerance = 1e-4F;

bool is_above_zero(float number) {
  return std::isfinite(number) && number > 0;
}

bool is_direction(float direction) {
  constexpr float kSector = std::numbers::pi_v<float> / 4;
  const float sectors = direction / kSector;
  const float nearest = std::round(sectors);
  return nearest > -4 && nearest <= 4 &&
         std::abs(sectors - nearest) * kSector <= kDirectionTolerance;
}

const char* fault_of(const Annotation& annotation, float duration_s) {
  if (static_cast<int>(annotation.target) >= motion::kTargetCount) return "has an unknown target";
  if (annotation.degree > motion::Degree::exaggerated) return "has an unknown degree";
  if (!is_direction(annotation.direction)) return "has a direction that is not one of the eight";
  const bool in_order = annotation.onset_s >= 0 && annotation.onset_s < annotation.peak_s &&
                        annotation.peak_s <= annotation.end_s &&
                        annotation.end_s <= duration_s + kTimeTolerance_s;
  return in_order ? nullptr : "breaks 0 <= onset < peak <= end <= duration";
}

const char* fault_of(const Clip& clip, float rate_hz) {
  if (clip.name.empty()) return "has no name";
  if (clip.purpose > motion::Purpose::push) return "has an unknown purpose";
  if (clip.motion.rate_hz != rate_hz) return "has another rate than its library";
  if (clip.motion.poses.empty()) return "has no poses";
  if (!std::ranges::all_of(clip.motion.poses, [](const Pose& pose) { return is_sound(pose); })) {
    return "has a pose with a number that is not finite or a rotation that is not a unit one";
  }
  return clip.annotation ? fault_of(*clip.annotation, clip.motion.duration_s()) : nullptr;
}

}  // namespace

const char* fault_of(const motion::Physique& character) {
  const auto is_finite = [](const Eigen::Vector3f& vector) { return vector.allFinite(); };
  const motion::Skeleton& skeleton = character.skeleton;
  if (!std::all_of(skeleton.offset.begin(), skeleton.offset.end(), is_finite) ||
      !std::all_of(skeleton.tip.begin(), skeleton.tip.end(), is_finite)) {
    return "the skeleton has a number that is not finite";
  }
  if (!is_above_zero(character.mass_kg)) return "the character's mass is not above 0";
  if (character.sex > motion::Sex::male) return "the character's sex is unknown";
  return nullptr;
}

std::optional<LibraryFault> fault_of(const ClipLibrary& library) {
  const auto whole = [](const char* what) { return LibraryFault{std::nullopt, what}; };
  if (library.name.empty()) return whole("the library has no name");
  if (!is_above_zero(library.rate_hz)) return whole("the rate is not above 0");
  if (const char* what = fault_of(library.character)) return whole(what);
  if (library.idle < 0 || static_cast<std::size_t>(library.idle) >= library.clips.size()) {
    return whole("there is no idle clip");
  }
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < library.clips.size(); ++i) {
    const Clip& clip = library.clips[i];
    if (const char* what = fault_of(clip, library.rate_hz)) return LibraryFault{i, what};
    if (!names.insert(clip.name).second) return LibraryFault{i, "shares its name with another"};
  }
  return std::nullopt;
}

}  // namespace flinch::database
