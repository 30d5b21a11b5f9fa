// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/bvh.h"
#include "database/import/scene.h"

namespace flinch::database {

/// Returns the figure of a scene and its motion as a BVH file would hold them, in metres, Y up.
///
/// The figure is the tree of nodes with most joints: nodes that are bones of a skin or animated,
/// and what lies between. Without a skin, nodes that do not move are joints too, and where that
/// tree is no human, the one around it that is. Ends without a mesh, such as `HeadTop_End`, become
/// End Sites. Nodes that have other axes than the world in the rest pose, and helper nodes, are
/// allowed for: joint j has
///
///     R'_j(t) = the rotation of M_j(t) M_j(rest)^-1,
///
/// where M is the linear part of a node's global transform, which is the world's in the rest pose.
/// So are scales of nodes: positions are those in the world. The rest pose is that of the nodes
/// without the animation.
///
/// Frames follow each other as keys do in the median, or, where these are more than 0.1 s apart, at
/// 30 Hz; only the keys of the figure and of what is above it count. Between keys, positions are
/// linear and rotations slerped; a warning tells of keys that are so far apart that this matters.
///
/// Throws Error for a scene without a figure, with more than 4096 joints, or with more frames than
/// its keys and kMaxFrames justify.
Bvh scene_motion(const Scene& scene);

}  // namespace flinch::database
