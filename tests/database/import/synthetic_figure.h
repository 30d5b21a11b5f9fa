// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/import/bvh.h"
#include "motion/skeleton.h"

namespace flinch::tests {

/// How a made BVH file differs from the library's conventions.
struct SyntheticRig {
  motion::PerRole<std::string> names;  ///< empty: the rig has no such joint
  /// Of a joint of no length above every named one, whose name this follows; empty: none.
  std::string dummy_suffix;
  /// Of a joint half-way down every bone, whose name this follows; empty: none.
  std::string twist_suffix;
  motion::Pose rest;  ///< the pose that the OFFSETs draw
  double units_per_metre = 100;
  Eigen::Quaterniond axes;  ///< from the library's axes to the file's

  SyntheticRig();  ///< T-pose, centimetres, Y up and Z forward, named after the roles
};

/// A BVH file of the poses of a skeleton, made by other code than the importer's: every joint's
/// world orientation is the pose's times the inverse of the rest pose's.
database::Bvh synthetic_bvh(const motion::Skeleton& skeleton, const SyntheticRig& rig,
                            const std::vector<motion::Pose>& poses, double frame_time_s);

/// Names for a rig, from the pelvis outwards; the limbs' for the left side with "Left" or whatever
/// `left` is, which becomes `right` on the other. A limb is given as "clavicle upper_arm forearm
/// hand" or "thigh shin foot toes", "-" where the rig has none.
motion::PerRole<std::string> rig_names(const std::vector<std::string>& spine,
                                       const std::vector<std::string>& left_arm,
                                       const std::vector<std::string>& left_leg,
                                       const std::string& left, const std::string& right);

}  // namespace flinch::tests
