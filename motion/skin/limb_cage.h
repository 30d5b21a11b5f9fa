// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "motion/skin/figure_cage.h"

namespace flinch::motion {

/// The axes of a limb's cross-section, unit.
struct LimbAxes {
  Eigen::Vector3f along;  ///< from the near to the far end
  Eigen::Vector3f front;
  Eigen::Vector3f side;  ///< up for an arm in the T-pose, outward for a leg
};
/// Returns axes for a limb in this direction; without length, in the default direction.
LimbAxes limb_axes(Side side, const Eigen::Vector3f& direction,
                   const Eigen::Vector3f& default_direction);

/// Half diameters of a cross-section of eight points.
struct Section {
  float front, side, back, other_side;
  float corner = 0.7071F;  ///< of the points between, as a share of both: above 0.7071 more square
};

/// Returns the eight points of a cross-section: front, side, back, other side and those between.
std::array<Eigen::Vector3f, 8> section_points(const LimbAxes& axes, const Eigen::Vector3f& centre,
                                              const Section& section);

/// One ring of a limb: where along a bone, its half diameters in radii of the bone's outline, and
/// the weights of the bone's parent and of its child.
struct LimbRow {
  Role left_bone;
  float along;
  Section section;
  float parent_weight;
  float child_weight;
  Covering covering;  ///< of the faces up to the ring before
};
/// Adds the vertices of a row.
Ring add_limb_row(const CageGuide& guide, Side side, const LimbRow& row, CageBuilder& builder);

}  // namespace flinch::motion
