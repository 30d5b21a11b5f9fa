// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

#include "motion/clip.h"

namespace flinch::database {

/// The bounds of what a library, a selector or a store may hold; docs/files.md has the table. They
/// are far outside what people and their motion need, and far inside what single precision and the
/// solvers of the run time can compute with.

inline constexpr std::size_t kMaxClips = 10'000;
inline constexpr std::size_t kMaxPoses = 1'000'000;  ///< of one clip
inline constexpr std::size_t kMaxNameSize = 255;     ///< bytes of a name or kind
inline constexpr std::size_t kMaxSourceSize = 4096;  ///< bytes of a clip's source, which has a path

/// Bytes of the text that tells how a library, a store or a selector was made.
inline constexpr std::size_t kMaxProvenanceSize = std::size_t{1} << 20;

inline constexpr float kMinRate_hz = 1;
inline constexpr float kMaxRate_hz = 1000;
inline constexpr float kMinMass_kg = 1;
inline constexpr float kMaxMass_kg = 1000;

inline constexpr float kMaxBone_m = 5;      ///< of any offset or tip
inline constexpr float kMinLimb_m = 0.01F;  ///< of upper arm, forearm, thigh and shin
/// Distance between the shoulders, and between the hips.
inline constexpr float kMinBreadth_m = 0.01F;
inline constexpr float kMinStature_m = 0.2F;
inline constexpr float kMaxStature_m = 20;
/// Of a root, and of the centre of a target, from the origin, along each axis.
inline constexpr float kMaxDistance_m = 1000;

/// Between a clip's onset and its peak: no motion is shorter, and the run time divides by it.
inline constexpr float kMinRise_s = 1e-3F;
/// Of times in clips whose motion is not in the file: kMaxPoses at kMinRate_hz.
inline constexpr float kMaxTime_s = 1e6F;

/// Of the joint that a push moves: no one survives more.
inline constexpr float kMaxPushSpeed_mps = 20;

/// Returns what is wrong with the name of a library or clip, or null.
const char* fault_of_name(std::string_view name);

/// Returns what is wrong with the annotation of a clip that lasts `duration_s`, or null.
const char* fault_of(const motion::Annotation& annotation, float duration_s);

/// Returns what is wrong with the push of a clip that lasts `duration_s`, or null.
const char* fault_of(const motion::Push& push, float duration_s);

}  // namespace flinch::database
