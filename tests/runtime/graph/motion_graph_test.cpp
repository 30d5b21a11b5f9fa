// SPDX-License-Identifier: MIT
#include "runtime/graph/motion_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/runtime/push/push_scene.h"

namespace flinch::runtime {
namespace {

/// The library with a clip from which there is no way back, before all others but the idle clip:
/// its hands stay where they have been raised.
database::ClipLibrary library_with_a_dead_end() {
  database::ClipLibrary library = tests::library_with_walks();
  for (motion::Clip& clip : library.clips) {
    if (clip.name != "raise_hands") continue;
    const auto peak = static_cast<std::ptrdiff_t>(clip.annotation->peak_s * clip.motion.rate_hz);
    clip.motion.poses.resize(static_cast<std::size_t>(peak));
    clip.annotation.reset();
  }
  return library;
}

struct GraphScene {
  database::ClipLibrary library = library_with_a_dead_end();
  PreparedLibrary prepared = prepare(library);
  MotionGraph graph = make_motion_graph(prepared);
};

const GraphScene& scene() {
  static const GraphScene one;
  return one;
}

/// The nodes that can be reached from one, or, backwards, from which it can be.
std::set<std::uint32_t> reached(const MotionGraph& graph, std::uint32_t from, bool backwards) {
  std::vector<std::vector<std::uint32_t>> edges(graph.nodes.size());
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    backwards ? edges[b].push_back(a) : edges[a].push_back(b);
  };
  for (std::uint32_t k = 0; k < graph.nodes.size(); ++k) {
    if (graph.goes_on[k]) add(k, k + 1);
    for (const std::uint32_t to : graph.jumps_of(k)) add(k, to);
  }
  std::set<std::uint32_t> found{from};
  std::vector<std::uint32_t> left{from};
  while (!left.empty()) {
    const std::uint32_t node = left.back();
    left.pop_back();
    for (const std::uint32_t to : edges[node]) {
      if (found.insert(to).second) left.push_back(to);
    }
  }
  return found;
}

motion::PoseFeatures features_of(const GraphNode& node) {
  constexpr float kStep_s = 1.0F / 60;
  const motion::Motion& motion = scene().library.clip(node.clip).motion;
  const float to_s = std::max(node.time_s, kStep_s);
  return motion::PoseMetric(scene().library.character)
      .features(motion::sample(motion, to_s - kStep_s), motion::sample(motion, to_s), kStep_s);
}

TEST(MotionGraph, EveryMomentCanBeReachedFromEveryOther) {
  const MotionGraph& graph = scene().graph;
  ASSERT_GT(graph.nodes.size(), 60U);
  ASSERT_EQ(graph.first_jump.size(), graph.nodes.size() + 1);
  for (const bool backwards : {false, true})
    EXPECT_EQ(reached(graph, 0, backwards).size(), graph.nodes.size());
  std::set<int> clips;
  for (const GraphNode& node : graph.nodes) clips.insert(node.clip);
  EXPECT_GE(clips.size(), 3U) << "the idle clip and both walks";
  for (const GraphNode& node : graph.nodes) {
    EXPECT_TRUE(scene().library.clip(node.clip).name != "raise_hands" || node.time_s < 0.3F);
  }
}

TEST(MotionGraph, NoEdgeLeadsIntoAPushOrAnAnswerToAThreat) {
  for (const GraphNode& node : scene().graph.nodes) {
    const motion::Clip& clip = scene().library.clip(node.clip);
    EXPECT_FALSE(clip.push) << clip.name;
    EXPECT_FALSE(clip.annotation) << clip.name;
  }
}

TEST(MotionGraph, JumpsAreToTheNearestMomentOfAClipWithinTheBound) {
  const MotionGraph& graph = scene().graph;
  std::size_t jumps = 0;
  for (std::uint32_t k = 0; k < graph.nodes.size(); ++k) {
    const motion::PoseFeatures from = features_of(graph.nodes[k]);
    for (const std::uint32_t to : graph.jumps_of(k)) {
      ++jumps;
      const float distance =
          std::sqrt(motion::squared_distance(from, features_of(graph.nodes[to])));
      EXPECT_LE(distance, motion::kMaxSeamDistance_m + 1e-5F);
      const bool is_same = graph.nodes[k].clip == graph.nodes[to].clip;
      EXPECT_TRUE(!is_same || std::abs(graph.nodes[k].time_s - graph.nodes[to].time_s) >= 1);
      for (const GraphNode& other : graph.nodes) {
        if (other.clip != graph.nodes[to].clip) continue;
        if (is_same && std::abs(graph.nodes[k].time_s - other.time_s) < 1) continue;
        EXPECT_GE(std::sqrt(motion::squared_distance(from, features_of(other))), distance - 1e-5F);
      }
    }
  }
  EXPECT_GT(jumps, 50U);
}

TEST(MotionGraph, ResponsesLeadBackWhereTheyAreNearest) {
  const MotionGraph& graph = scene().graph;
  ASSERT_EQ(graph.exits.size(), scene().library.clips.size());
  int responses = 0;
  for (std::size_t i = 0; i < graph.exits.size(); ++i) {
    const motion::Clip& clip = scene().library.clips[i];
    if (!clip.push) continue;
    ++responses;
    const GraphExit& exit = graph.exits[i];
    EXPECT_GE(exit.leave_s, clip.push->peak_s);
    EXPECT_LE(exit.leave_s, clip.motion.duration_s());
    EXPECT_GE(exit.leave_s, clip.motion.duration_s() - 1.001F);
    const motion::PoseFeatures from = features_of({static_cast<int>(i), exit.leave_s});
    const float distance = motion::squared_distance(from, features_of(graph.nodes[exit.node]));
    for (const GraphNode& node : graph.nodes)
      EXPECT_GE(motion::squared_distance(from, features_of(node)), distance - 1e-6F);
  }
  EXPECT_EQ(responses, 6);
}

TEST(MakeMotionGraph, IsEmptyWithoutEverydayClips) {
  database::ClipLibrary library = tests::library_with_walks();
  for (motion::Clip& clip : library.clips) clip.purpose = motion::Purpose::push;
  EXPECT_TRUE(make_motion_graph(prepare(library)).nodes.empty());
}

TEST(DrawExit, StaysForAWhileThenTakesEveryWayAndIsSeeded) {
  const MotionGraph& graph = scene().graph;
  std::set<std::uint32_t> ways;
  for (std::uint64_t k = 0; k < 300; ++k) {
    const std::uint32_t node = 0;
    features::Random random(5, features::RandomStream::motion_walk, k);
    features::Random again(5, features::RandomStream::motion_walk, k);
    const GraphExit exit = draw_exit(graph, node, random);
    const GraphExit same = draw_exit(graph, node, again);
    EXPECT_EQ(exit.leave_s, same.leave_s);
    EXPECT_EQ(exit.node, same.node);
    EXPECT_GE(exit.leave_s - graph.nodes[node].time_s, kGraphStep_s);
    ways.insert(exit.node);
    // It leaves at a moment that can jump there.
    bool can = false;
    for (std::uint32_t from = node; from < graph.nodes.size(); ++from) {
      if (graph.nodes[from].clip != graph.nodes[node].clip) break;
      if (std::abs(graph.nodes[from].time_s - exit.leave_s) > 0.01F) continue;
      can = can || std::ranges::count(graph.jumps_of(from), exit.node) > 0;
    }
    EXPECT_TRUE(can);
  }
  EXPECT_GT(ways.size(), 3U);
}

TEST(NearestNode, IsTheMomentThatTheCharacterIsIn) {
  const MotionGraph& graph = scene().graph;
  for (std::uint32_t k = 3; k < graph.nodes.size(); k += 7) {
    const GraphNode& node = graph.nodes[k];
    if (node.time_s < 0.1F) continue;
    const motion::Motion& motion = scene().library.clip(node.clip).motion;
    const auto pose = [&](float time_s) {
      return motion::placed(motion::sample(motion, time_s), 1.3F, {4, 1, 0});
    };
    const std::uint32_t found =
        nearest_node(graph, pose(node.time_s - 1.0F / 60), pose(node.time_s), 1.0F / 60);
    EXPECT_LT(motion::squared_distance(features_of(node), features_of(graph.nodes[found])), 1e-6F);
  }
}

}  // namespace
}  // namespace flinch::runtime
