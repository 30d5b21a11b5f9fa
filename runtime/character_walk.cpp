// SPDX-License-Identifier: MIT
// How a character moves about by the motion graph of its library.
#include <algorithm>
#include <new>

#include "runtime/character.h"
#include "runtime/graph/motion_graph.h"

namespace flinch::runtime {
namespace {

constexpr float kWalkVelocityInterval_s = 1.0F / 240;
constexpr int kMostJumps = 64;  // in one frame

}  // namespace

std::shared_ptr<const MotionGraph> make_motion_graph(const Library& library) noexcept try {
  if (!library.is_loaded()) return nullptr;
  return std::make_shared<const MotionGraph>(make_motion_graph(library.prepared()));
} catch (const std::bad_alloc&) {
  return nullptr;
}

Status Character::walk(const MotionGraph& graph, std::uint64_t seed) noexcept {
  if (!library_->is_loaded() || graph.library != &library_->prepared() || graph.nodes.empty())
    return Status::not_loaded;
  walk_ = {};
  walk_.graph = &graph;
  walk_.seed = seed;
  walk_on();
  return Status::ok;
}

// A character that answers nothing enters the graph where it is nearest; one that is in it, or in
// a response to a push, goes on when the time has come. What a very long frame leaves is dropped.
void Character::walk_on() noexcept {
  if (is_responding()) return;
  if (!is_pushed()) {
    const auto now_s = static_cast<float>(time_s_);
    jump_to(nearest_node(*walk_.graph, pose_after(now_s - kWalkVelocityInterval_s),
                         pose_after(now_s), kWalkVelocityInterval_s));
  }
  for (int k = 0; k < kMostJumps && time_s_ >= double{walk_.leave_s}; ++k) {
    const double rest_s = time_s_ - double{walk_.leave_s};
    time_s_ = double{walk_.leave_s};
    jump_to(walk_.node);
    time_s_ = rest_s;
  }
  time_s_ = std::min(time_s_, double{walk_.leave_s});
}

void Character::jump_to(std::uint32_t node) noexcept {
  const GraphNode& to = walk_.graph->nodes[node];
  const auto now_s = static_cast<float>(time_s_);
  push_ = make_transition(library_->prepared(), to.clip, to.time_s,
                          pose_after(now_s - kWalkVelocityInterval_s), pose_after(now_s),
                          kWalkVelocityInterval_s);
  is_answering_push_ = false;
  inertialization_ = {};
  time_s_ = 0;
  features::Random random(walk_.seed, features::RandomStream::motion_walk, walk_.stays++);
  const GraphExit exit = draw_exit(*walk_.graph, node, random);
  walk_.leave_s = exit.leave_s - to.time_s;
  walk_.node = exit.node;
}

}  // namespace flinch::runtime
