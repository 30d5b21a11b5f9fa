// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "motion/body.h"
#include "motion/clip.h"
#include "motion/foot.h"

namespace flinch::runtime {

/// A time in which a foot is off the ground, s of the clip.
struct Swing {
  float begin_s = 0;
  float end_s = 0;
};

/// What a clip does with its feet.
struct Footwork {
  motion::PerSide<std::vector<Swing>> swings;  ///< in order of time
  /// The foot that carries more weight in the clip's opening: the one that stays where the other
  /// leaves the ground before the peak, else the one nearer to the centre of mass.
  motion::Side support = motion::Side::left;
};

/// The sole's corners in the frame of its foot and of its toes, m.
struct Sole {
  std::vector<Eigen::Vector3f> foot;
  std::vector<Eigen::Vector3f> toes;
  /// The whole sole's hull on flat ground, counter-clockwise, in the foot's frame seen from above.
  std::vector<Eigen::Vector2f> hull;
  Eigen::Vector2f middle;  ///< of the hull's corners
};

Sole make_sole(const motion::Skeleton& skeleton, motion::Side side);

/// The pelvis and the leg down to the foot, parents first: what places a foot.
std::span<const motion::Role> roles_to_foot(motion::Side side);

/// Ankle and orientation of one foot alone, world: cheaper than all joints.
motion::FootPlace foot_of(const motion::Skeleton& skeleton, const motion::Pose& pose,
                          motion::Side side);

/// Lowest point of a sole in the world, z, m, of a foot at this place whose toes are turned by
/// `toes` against it. `toes_offset` is the skeleton's.
float lowest_point(const Sole& sole, const motion::FootPlace& foot, const Eigen::Quaternionf& toes,
                   const Eigen::Vector3f& toes_offset);
float lowest_point(const Sole& sole, const motion::JointFrames& frames, motion::Side side);

/// A foot stands where a point of its sole is within this of the ground, m.
inline constexpr float kStanding = 0.008F;

/// Works out the footwork of a clip, from its onset on; that of a clip without an annotation from
/// its beginning. Swings shorter than 0.05 s are noise and left out, as are stands between swings.
Footwork footwork_of(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                     const motion::PerSide<Sole>& soles, const motion::Clip& clip);

}  // namespace flinch::runtime
