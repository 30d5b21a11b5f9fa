// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "database/import/source_motion.h"
#include "motion/skeleton.h"

namespace flinch::database {

/// Bends a skeleton's trunk so that its shoulders and head are where the source's are relative to
/// the hips, in the proportions of the skeleton's trunk. The joints of the two spines need not be
/// at the same heights: rotations alone, copied from joints elsewhere, would move head and hands.
///
/// Each part of the spine takes the direction of the same part of the source's spine, a line
/// through its joints. Damped least squares (Wampler 1986, IEEE Transactions on Systems, Man, and
/// Cybernetics 16) then reduce the remaining error. The damping keeps the motion smooth: a nearly
/// straight spine that is a little too long would else have to bend far, to an arbitrary side.
class TrunkFit {
 public:
  TrunkFit(const SourceMotion& source, const motion::Skeleton& skeleton);

  /// Turns abdomen, chest, neck and clavicles of a source's frame; orientations are the world's.
  void bend(const SourceFrame& frame, motion::PerRole<Eigen::Quaternionf>& orientation) const;

 private:
  // The source's spine is a line from the hips through these points. `share` is a point's height
  // over that of the shoulders in the reference pose.
  struct Corner {
    Eigen::Vector3f SourceTrunk::*point;
    float share;
  };

  Eigen::Vector3f point_of(const SourceTrunk& trunk, float share) const;
  void align(motion::Role role, float from, float to, const SourceTrunk& trunk,
             motion::PerRole<Eigen::Quaternionf>& orientation) const;
  void pull_spine(const SourceTrunk& trunk, motion::PerRole<Eigen::Quaternionf>& orientation) const;
  Eigen::Vector3f goal(Eigen::Vector3f SourceTrunk::*point, const SourceTrunk& trunk,
                       const Eigen::Quaternionf& carrier) const;

  SourceTrunk source_rest_;
  SourceTrunk rest_;                                // the skeleton's
  Eigen::Vector3f neck_;                            // likewise
  Eigen::Vector3f left_clavicle_, right_clavicle_;  // likewise
  std::vector<Corner> corners_;                     // from the hips up, the last at the shoulders
  float scale_ = 1;                                 // from the source's trunk to the skeleton's
};

}  // namespace flinch::database
