// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/import/bvh.h"
#include "motion/skeleton.h"

namespace flinch::tests {

/// How a synthetic BVH file differs from the library's conventions.
struct SyntheticRig {
  motion::PerRole<std::string> names;  ///< empty: the rig has no such joint
  /// Suffix of an additional joint of zero length above every named one; empty: none.
  std::string dummy_suffix;
  /// Suffix of an additional joint halfway along every bone; empty: none.
  std::string twist_suffix;
  motion::Pose rest;  ///< the pose that the OFFSETs form
  double units_per_metre = 100;
  Eigen::Quaterniond axes;  ///< from the library's axes to the file's

  SyntheticRig();  ///< T-pose, centimetres, Y up and Z forward, named after the roles
};

/// Returns a BVH file with the poses of a skeleton, independently of the importer's code: every
/// joint's world orientation is the pose's times the inverse of the rest pose's.
database::Bvh synthetic_bvh(const motion::Skeleton& skeleton, const SyntheticRig& rig,
                            const std::vector<motion::Pose>& poses, double frame_time_s);

/// Returns the names for a rig, from the pelvis outwards. Names of limbs are given for the left
/// side; `left`, such as "Left", is replaced by `right` for the other side. A limb is given as
/// "clavicle upper_arm forearm hand" or "thigh shin foot toes", with "-" where the rig has none.
motion::PerRole<std::string> rig_names(const std::vector<std::string>& spine,
                                       const std::vector<std::string>& left_arm,
                                       const std::vector<std::string>& left_leg,
                                       const std::string& left, const std::string& right);

}  // namespace flinch::tests
