// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/body.h"

namespace flinch::evolve {

/// Places on a body that hurt alike (Rose 2006, section 4.2.1): analytic patches on the outlines of
/// the figure, where the thesis colours the triangles of a mesh.
enum class PainRegion : std::uint8_t {
  eyes,
  nose,
  face,  ///< the front of the head from the chin to the hairline, without eyes and nose
  head,  ///< the rest of the head
  neck,
  chest,
  stomach,
  pelvis,
  upper_arm,
  forearm_inside,   ///< the side of the palm
  forearm_outside,  ///< the side of the back of the hand
  palm,
  back_of_hand,
  thigh,
  shin,
  foot,
};
inline constexpr int kPainRegionCount = 16;
/// All regions, from the top down, for range-based loops.
inline constexpr auto kPainRegions = motion::all_enumerators<PainRegion, kPainRegionCount>();
/// One value per region.
template <class T>
using PerPainRegion = motion::EnumArray<PainRegion, T, kPainRegionCount>;

/// The name in files and messages, such as "back_of_hand".
std::string_view name_of(PainRegion region);
/// The region with this name, if there is one.
std::optional<PainRegion> pain_region_named(std::string_view name);

/// The regions that a body has.
std::vector<PainRegion> regions_of(motion::Body body);

/// The region of a point on the surface of a body. `point` is in the frame of the body's joint, m.
PainRegion pain_region_at(const motion::BodyModel& bodies, motion::Body body,
                          const Eigen::Vector3f& point);

}  // namespace flinch::evolve
