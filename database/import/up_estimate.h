// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/reference_pose.h"

namespace flinch::database {

/// Up axis of a file, and how sure it is.
struct UpEstimate {
  UpAxis up = UpAxis::y;
  /// The component along `up` of the mean direction from feet to head, 0 to 1; 1 where the OFFSETs
  /// stand.
  double certainty = 0;
  std::optional<UpAxis> rival;  ///< the axis of the other vote, where there are two that differ
};

/// Estimates the up axis by two votes: the axis nearest to the mean direction from feet to head
/// over the motion and, where the OFFSETs form a standing human, the axis along which that stands.
///
/// Where they differ, the file may hold someone on hands and feet or lying, or a figure made with Y
/// up and recorded with Z up. Then the axis wins with which the body is more like one on the
/// ground: with its centre of mass above the hull of what is lowest, and that near the height 0.
UpEstimate estimate_up(const Bvh& bvh, const SourceFigure& figure);

}  // namespace flinch::database
