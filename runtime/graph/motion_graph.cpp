// SPDX-License-Identifier: MIT
#include "runtime/graph/motion_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/graph/strong_components.h"

namespace flinch::runtime {
namespace {

using motion::PoseFeatures;

constexpr float kDifference_s = 1.0F / 60;  // over which velocities are measured
constexpr float kMinGap_s = 1;              // of a jump within a clip
constexpr float kExitWindow_s = 1;          // at the end of a response

bool is_everyday(const motion::Clip& clip) {
  return clip.purpose != motion::Purpose::push && !clip.annotation && !clip.push;
}

PoseFeatures features_at(const motion::PoseMetric& metric, const motion::Motion& motion,
                         float time_s) {
  const float to_s = std::max(time_s, kDifference_s);  // the first pose has none before it
  return metric.features(motion::sample(motion, to_s - kDifference_s), motion::sample(motion, to_s),
                         kDifference_s);
}

/// All moments of the everyday clips.
MotionGraph all_moments(const PreparedLibrary& library) {
  MotionGraph graph(library);
  const std::vector<motion::Clip>& clips = library.library->clips;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!is_everyday(clips[i])) continue;
    const motion::Motion& motion = clips[i].motion;
    for (int k = 0; static_cast<float>(k) * kGraphStep_s <= motion.duration_s(); ++k) {
      const float time_s = static_cast<float>(k) * kGraphStep_s;
      graph.nodes.push_back({static_cast<int>(i), time_s});
      graph.places.push_back(features_at(graph.metric, motion, time_s));
    }
  }
  return graph;
}

bool are_neighbours(const GraphNode& one, const GraphNode& other) {
  return one.clip == other.clip && std::abs(one.time_s - other.time_s) < kMinGap_s;
}

bool follows(const GraphNode& node, const GraphNode& before) {
  return node.clip == before.clip && node.time_s - before.time_s < 1.5F * kGraphStep_s;
}

/// The nearest node of each clip within kMaxSeamDistance_m.
std::vector<std::uint32_t> jumps_from(const MotionGraph& graph, std::size_t from) {
  constexpr float kBound = motion::kMaxSeamDistance_m * motion::kMaxSeamDistance_m;
  std::vector<std::uint32_t> jumps;
  for (std::size_t begin = 0, end = 0; begin < graph.nodes.size(); begin = end) {
    float least = kBound;
    std::size_t nearest = graph.nodes.size();
    for (; end < graph.nodes.size() && graph.nodes[end].clip == graph.nodes[begin].clip; ++end) {
      if (are_neighbours(graph.nodes[from], graph.nodes[end])) continue;
      const float squared = motion::squared_distance(graph.places[from], graph.places[end], least);
      if (squared > least || (squared == least && nearest < graph.nodes.size())) continue;
      least = squared;
      nearest = end;
    }
    if (nearest < graph.nodes.size()) jumps.push_back(static_cast<std::uint32_t>(nearest));
  }
  return jumps;
}

/// The part of a graph with these nodes, of which edges to others are left out.
MotionGraph part_of(const MotionGraph& all, const Successors& jumps,
                    const std::vector<std::uint32_t>& kept) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(all.nodes.size(), kNone);
  for (std::uint32_t k = 0; k < kept.size(); ++k) number[kept[k]] = k;
  MotionGraph part(*all.library);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::uint32_t node = kept[k];
    part.nodes.push_back(all.nodes[node]);
    part.places.push_back(all.places[node]);
    part.goes_on.push_back(k + 1 < kept.size() && follows(all.nodes[kept[k + 1]], all.nodes[node]));
    part.first_jump.push_back(static_cast<std::uint32_t>(part.jumps.size()));
    for (const std::uint32_t to : jumps[node]) {
      if (number[to] != kNone) part.jumps.push_back(number[to]);
    }
  }
  part.first_jump.push_back(static_cast<std::uint32_t>(part.jumps.size()));
  return part;
}

struct Nearest {
  std::uint32_t node = 0;
  float squared = std::numeric_limits<float>::infinity();
};
Nearest nearest_to(const MotionGraph& graph, const PoseFeatures& features) {
  Nearest nearest;
  for (std::uint32_t k = 0; k < graph.places.size(); ++k) {
    const float squared = motion::squared_distance(features, graph.places[k], nearest.squared);
    if (squared < nearest.squared) nearest = {k, squared};
  }
  return nearest;
}

GraphExit exit_of(const MotionGraph& graph, const motion::Clip& clip) {
  const float last_s = clip.motion.duration_s();
  const float first_s = std::max(last_s - kExitWindow_s, clip.push->peak_s);
  GraphExit exit{last_s, 0};
  float least = std::numeric_limits<float>::infinity();
  for (int k = 0; first_s + static_cast<float>(k) * kGraphStep_s <= last_s; ++k) {
    const float time_s = first_s + static_cast<float>(k) * kGraphStep_s;
    const Nearest nearest = nearest_to(graph, features_at(graph.metric, clip.motion, time_s));
    if (!(nearest.squared < least)) continue;
    least = nearest.squared;
    exit = {time_s, nearest.node};
  }
  return exit;
}

}  // namespace

MotionGraph make_motion_graph(const PreparedLibrary& library) {
  const MotionGraph all = all_moments(library);
  if (all.nodes.empty()) return all;
  Successors jumps(all.nodes.size());
  Successors successors(all.nodes.size());
  for (std::size_t k = 0; k < all.nodes.size(); ++k) {
    jumps[k] = successors[k] = jumps_from(all, k);
    if (k + 1 < all.nodes.size() && follows(all.nodes[k + 1], all.nodes[k]))
      successors[k].push_back(static_cast<std::uint32_t>(k + 1));
  }
  const std::vector<std::uint32_t> component_of = strong_components(successors);
  const std::uint32_t largest = largest_component(component_of);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t k = 0; k < component_of.size(); ++k) {
    if (component_of[k] == largest) kept.push_back(k);
  }
  MotionGraph graph = part_of(all, jumps, kept);
  for (const motion::Clip& clip : library.library->clips)
    graph.exits.push_back(clip.push ? exit_of(graph, clip) : GraphExit{});
  return graph;
}

std::uint32_t nearest_node(const MotionGraph& graph, const motion::Pose& before,
                           const motion::Pose& now, float dt_s) noexcept {
  return nearest_to(graph, graph.metric.features(before, now, dt_s)).node;
}

// A node that neither goes on nor jumps is the only one of its graph: the walk stays there.
GraphExit draw_exit(const MotionGraph& graph, std::uint32_t node, features::Random& random,
                    float min_stay_s) noexcept {
  const float entered_s = graph.nodes[node].time_s;
  for (;; ++node) {
    const auto jumps = graph.jumps_of(node);
    const bool goes_on = graph.goes_on[node] != 0;
    const float time_s = std::max(graph.nodes[node].time_s, entered_s + kGraphStep_s);
    if (jumps.empty() && !goes_on) return {time_s, node};
    if (goes_on && (jumps.empty() || time_s - entered_s < min_stay_s)) continue;
    const std::uint64_t choice = random.index(jumps.size() + (goes_on ? 1 : 0));
    if (choice < jumps.size()) return {time_s, jumps[static_cast<std::size_t>(choice)]};
  }
}

}  // namespace flinch::runtime
