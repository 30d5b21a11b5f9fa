// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "features/random.h"
#include "motion/pose_distance.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {

/// A moment of a clip.
struct GraphNode {
  int clip = 0;  ///< index in the library
  float time_s = 0;
};

/// Where a clip is left, and with which node the motion goes on.
struct GraphExit {
  float leave_s = 0;  ///< time in the clip
  std::uint32_t node = 0;
};

/// Which moments of a library's everyday clips can follow each other (Kovar, Gleicher and Pighin
/// 2002, "Motion graphs"; Arikan et al. 2005, section 4). Every node can be reached from every
/// other. No edge leads into a response to a push; exits lead from responses back.
struct MotionGraph {
  /// Without nodes.
  explicit MotionGraph(const PreparedLibrary& of) : library(&of), metric(of.library->character) {}

  const PreparedLibrary* library;
  motion::PoseMetric metric;
  std::vector<GraphNode> nodes;              ///< by clip, then time
  std::vector<motion::PoseFeatures> places;  ///< of the nodes, for nearest_node()
  std::vector<char> goes_on;                 ///< whether the next node follows this one in its clip
  /// The nodes that node k can jump to are jumps[first_jump[k]] to jumps[first_jump[k + 1] - 1].
  std::vector<std::uint32_t> first_jump;
  std::vector<std::uint32_t> jumps;
  std::vector<GraphExit> exits;  ///< one per clip of the library; for clips with a push

  std::span<const std::uint32_t> jumps_of(std::uint32_t node) const {
    return std::span(jumps).subspan(first_jump[node], first_jump[node + 1] - first_jump[node]);
  }
};

/// The time between two nodes of a clip, s.
inline constexpr float kGraphStep_s = 1.0F / 15;

/// Makes the graph of a library with an idle clip. A moment can jump to the nearest one of each
/// clip, at least 1 s away in its own, if that is within motion::kMaxSeamDistance_m. The nodes are
/// those of the largest strongly connected part. The exit of a response is where in its last second
/// it is nearest to a node. Costs some 20 ns per pair of nodes; allocates.
MotionGraph make_motion_graph(const PreparedLibrary& library);

/// The node whose pose and velocities are nearest to a character's, world: it is in pose `now`, and
/// was in pose `before` dt_s earlier, which is above 0.
std::uint32_t nearest_node(const MotionGraph& graph, const motion::Pose& before,
                           const motion::Pose& now, float dt_s) noexcept;

/// How a random walk that enters a clip at a node leaves it: it stays for at least `min_stay_s`
/// where it can, and then chooses at every node among going on and all jumps alike. No stay is
/// shorter than kGraphStep_s.
inline constexpr float kMinStay_s = 1.5F;
GraphExit draw_exit(const MotionGraph& graph, std::uint32_t node, features::Random& random,
                    float min_stay_s = kMinStay_s) noexcept;

}  // namespace flinch::runtime
