// SPDX-License-Identifier: MIT
#pragma once

#include "sim/figure/tree_constants.h"

namespace flinch::sim {

/// A step of several figures side by side, one per lane. The last index of each array is the lane.
/// World frame, except where a comment names another.
template <std::size_t kLanes>
struct TreeLanes {
  using Values = double[kLanes];
  struct Body {
    Values position[3], orientation[4], velocity[3], angular_velocity[3];
    Values impulse[3], angular_impulse[3];                     ///< of forces
    Values target_orientation[4], target_angular_velocity[3];  ///< at the end of the step
    Values socket[3];  ///< as ReferenceState; in the parent's frame
  };
  /// Springs from a body to the world; where there are none, their softness is infinite.
  struct Anchor {
    Values velocity[3], softness[3];
    Values angular_velocity[3], angular_softness[3];
  };
  /// The names are those of joint_tree.cpp.
  struct Link {
    Values to_joint[3], parent_to_joint[3], joint_to_joint[3];
    Values mobility[6];                                      ///< E: xx, yy, zz, xy, xz, yz
    Values coupling_mobility[3][3], angular_mobility[3][3];  ///< B E, C E, by columns
    Values prescribed[3], prescribed_angular[3];             ///< c_0
    Values angular[3];                                       ///< t
  };

  Body bodies[TreeConstants::kBodies];
  Anchor anchors[3];  ///< of the bodies in kAnchored
  Values step_s, gravity_mps2;
  Values joint_correction;                ///< share of a rigid joint's error corrected per second
  Values stiffness_share, damping_share;  ///< of the joints' springs

  Link links[TreeConstants::kBodies];  ///< of the pelvis: only `to_joint`
  Values root_inverse_inertia[6][6];
  Values root_velocity[6];
};

/// The bodies that may have springs to the world: the pelvis, the left foot and the right foot.
inline constexpr std::size_t kAnchored[] = {0, 13, 16};

/// Finds the equations of the joints over a step and factors them: writes the links and the root,
/// and reads the rest. Each lane has the bits that it has alone, for any number of lanes and
/// whatever is in the others, and so has move_figures(). Both are defined for 1 and 2 lanes and, on
/// processors with AVX2 or AVX-512, for 4 or 8.
template <std::size_t kLanes>
void factor_trees(const TreeConstants& constants, TreeLanes<kLanes>& lanes);
/// Gives the bodies the velocities that follow from links and root, to which contacts may have
/// added impulses, and moves them with these over the step (moved_on).
template <std::size_t kLanes>
void move_figures(const TreeConstants& constants, TreeLanes<kLanes>& lanes);

template <>
void factor_trees(const TreeConstants& constants, TreeLanes<1>& lanes);
template <>
void move_figures(const TreeConstants& constants, TreeLanes<1>& lanes);
template <>
void factor_trees(const TreeConstants& constants, TreeLanes<2>& lanes);
template <>
void move_figures(const TreeConstants& constants, TreeLanes<2>& lanes);
#ifdef __x86_64__
template <>
void factor_trees(const TreeConstants& constants, TreeLanes<4>& lanes);
template <>
void move_figures(const TreeConstants& constants, TreeLanes<4>& lanes);
template <>
void factor_trees(const TreeConstants& constants, TreeLanes<8>& lanes);
template <>
void move_figures(const TreeConstants& constants, TreeLanes<8>& lanes);
#endif

/// Returns how many lanes to step side by side on this processor: as many as it has in a register.
std::size_t widest_lanes();

/// limit_violation() of plain numbers, for the few joints that are near their limits.
void find_limit_violation(const TreeConstants::Range& range, const double (&rotation)[4],
                          const double (&reference)[4], double (&violation)[3]);

}  // namespace flinch::sim
