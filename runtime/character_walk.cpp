// SPDX-License-Identifier: MIT
// How a character moves about by the motion graph of its library.
#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include "motion/rotation.h"
#include "runtime/character.h"
#include "runtime/graph/motion_graph.h"
#include "runtime/pose_check.h"

namespace flinch::runtime {
namespace {

constexpr int kMaxJumps = 64;       // in one frame
constexpr int kLongStayDraws = 16;  // of ways on, each after a stay of at least kMinStay_s
constexpr int kMaxDraws = 32;       // the others may leave at once
constexpr float kAhead_s = 1.5F;    // that a walker looks ahead beyond a jump
constexpr float kAheadInterval_s = 0.5F;
constexpr std::array kPelvis{motion::Role::pelvis};

/// How far outside of its area a character in a clip will be some time after this exit, m; negative
/// inside.
float leads_out_m(const MotionGraph& graph, const PushMotion& now, const GraphExit& exit,
                  const WalkArea& area) {
  const PreparedLibrary& library = *now.library;
  const motion::Pose leaves =
      motion::placed(motion::sample(library.clip(now.clip).motion, exit.leave_s, kPelvis), now.yaw,
                     now.translation);
  const GraphNode& to = graph.nodes[exit.node];
  const motion::Motion& next = library.clip(to.clip).motion;
  const float from_s = std::max(std::min(to.time_s, next.duration_s() - kAheadInterval_s), 0.0F);
  const motion::Pose from = motion::sample(next, from_s, kPelvis);
  const Eigen::Vector3f way =
      motion::sample(next, from_s + kAheadInterval_s, kPelvis).root_position - from.root_position;
  const Eigen::Vector3f ahead =
      leaves.root_position +
      kAhead_s / kAheadInterval_s *
          (motion::rotation_about(Eigen::Vector3f::UnitZ(),
                                  motion::facing(leaves) - motion::facing(from)) *
           way);
  return (ahead.head<2>() - area.centre).norm() - area.radius_m;
}

}  // namespace

std::shared_ptr<const MotionGraph> make_motion_graph(const Library& library) noexcept try {
  if (!library.is_loaded()) return nullptr;
  return std::make_shared<const MotionGraph>(make_motion_graph(library.prepared()));
} catch (const std::bad_alloc&) {
  return nullptr;
}

Status Character::walk(const MotionGraph& graph, std::uint64_t seed,
                       const WalkArea& area) noexcept {
  if (!library_->is_loaded() || graph.library != &library_->prepared() || graph.nodes.empty())
    return Status::not_loaded;
  const bool is_near = area.centre.allFinite() && area.centre.cwiseAbs().maxCoeff() <= kMaxPlace_m;
  if (!is_near || !(area.radius_m > 0)) return Status::bad_placement;
  walk_ = {};
  walk_.graph = &graph;
  walk_.area = area;
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
    jump_to(nearest_node(*walk_.graph, pose_after(now_s - kVelocityInterval_s), pose_after(now_s),
                         kVelocityInterval_s));
  }
  for (int k = 0; k < kMaxJumps && time_s_ >= double{walk_.leave_s}; ++k) {
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
                          pose_after(now_s - kVelocityInterval_s), pose_after(now_s),
                          kVelocityInterval_s);
  is_answering_push_ = false;
  inertialization_ = {};
  time_s_ = 0;
  features::Random random(walk_.seed, features::RandomStream::motion_walk, walk_.stays++);
  float least_m = std::numeric_limits<float>::infinity();
  for (int k = 0; k < kMaxDraws && least_m > 0; ++k) {
    const float min_stay_s = k < kLongStayDraws ? kMinStay_s : 0;
    const GraphExit exit = draw_exit(*walk_.graph, node, random, min_stay_s);
    const float leave_s = exit.leave_s - to.time_s;
    const float out_m = leads_out_m(*walk_.graph, push_, exit, walk_.area);
    if (k > 0 && !(out_m < least_m)) continue;
    least_m = out_m;
    walk_.leave_s = leave_s;
    walk_.node = exit.node;
  }
}

}  // namespace flinch::runtime
