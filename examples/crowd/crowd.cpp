// SPDX-License-Identifier: MIT
#include "examples/crowd/crowd.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace flinch::crowd {
namespace {

using motion::Role;

constexpr float kRadius_m = 0.24F;        // of a body that is seen as a disc
constexpr float kMinPush_mps = 0.5F;      // a touch moves people apart, however slow they are
constexpr float kMaxPush_mps = 1.3F;      // about the strongest of recorded pushes
constexpr float kRestAfterPush_s = 0.6F;  // hands and walls push for about as long
constexpr float kRestAfterRefusal_s = 0.1F;

/// The joint that something pushes which comes from this direction, seen from the facing.
Role place_of(float bearing) {
  const float angle = std::abs(bearing);
  if (angle < 1.05F || angle > 2.1F) return Role::chest;  // 60 and 120 degrees
  return bearing > 0 ? Role::left_upper_arm : Role::right_upper_arm;
}

float wrapped(float angle) {
  return std::remainder(angle, 2 * static_cast<float>(M_PI));
}

}  // namespace

Crowd::Crowd(const runtime::Library& library, const runtime::MotionGraph& graph,
             const Options& options, runtime::Workspace& workspace)
    : options_(options),
      skeleton_(library.clip_library().character.skeleton),
      workspace_(workspace) {
  std::mt19937 random(static_cast<unsigned>(options.seed));
  const auto columns = static_cast<int>(std::ceil(std::sqrt(options.characters)));
  const float step_m = 2 * options.half_side_m / static_cast<float>(columns);
  for (int k = 0; k < options.characters; ++k) {
    runtime::Character character(library);
    const auto at = [&](int index) {
      return (static_cast<float>(index) + 0.5F) * step_m - options.half_side_m;
    };
    // mt19937's bits are the same everywhere; the distributions of the library are not.
    const float facing = static_cast<float>(random() % 360) * static_cast<float>(M_PI) / 180;
    const float idle_s = static_cast<float>(random() % 100) / 50;
    character.place({at(k % columns), at(k / columns)}, facing, idle_s);
    character.walk(graph, options.seed * 1000 + static_cast<std::uint64_t>(k));
    characters_.push_back(character);
  }
  bodies_.resize(characters_.size());
  observe(1);
  for (Body& body : bodies_) body.velocity.setZero();
}

void Crowd::observe(float dt_s) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const motion::Pose pose = characters_[i].pose();
    const Eigen::Vector2f chest =
        motion::forward_kinematics(skeleton_, pose).position[Role::chest].head<2>();
    bodies_[i].velocity = (chest - bodies_[i].chest) / dt_s;
    bodies_[i].chest = chest;
    bodies_[i].facing = motion::facing(pose);
    bodies_[i].rest_s -= dt_s;
  }
}

void Crowd::update(float dt_s) {
  for (runtime::Character& character : characters_) character.update(dt_s);
  observe(dt_s);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j) bump(i, j);
    touch_walls(i);
  }
}

// Both are pushed apart, as fast as they came together.
void Crowd::bump(std::size_t one, std::size_t other) {
  const Eigen::Vector2f between = bodies_[other].chest - bodies_[one].chest;
  const float distance_m = between.norm();
  if (distance_m >= 2 * kRadius_m || !(distance_m > 0)) return;
  const Eigen::Vector2f away = between / distance_m;
  const float closing_mps = (bodies_[one].velocity - bodies_[other].velocity).dot(away);
  if (closing_mps <= 0) return;
  const float speed_mps = std::clamp(closing_mps, kMinPush_mps, kMaxPush_mps);
  if (bodies_[one].rest_s <= 0 || bodies_[other].rest_s <= 0) ++tally_.bumps;
  push(one, -speed_mps * away);
  push(other, speed_mps * away);
}

void Crowd::touch_walls(std::size_t one) {
  const Body& body = bodies_[one];
  for (const int axis : {0, 1}) {
    const float side = body.chest[axis] > 0 ? 1.0F : -1.0F;
    const float outward_mps = side * body.velocity[axis];
    const bool is_beyond = side * body.chest[axis] > options_.half_side_m - kRadius_m;
    if (!is_beyond || outward_mps <= 0) continue;
    if (body.rest_s <= 0) ++tally_.walls;
    Eigen::Vector2f inward = Eigen::Vector2f::Zero();
    inward[axis] = -side * std::clamp(outward_mps, kMinPush_mps, kMaxPush_mps);
    push(one, inward);
  }
}

// A push that finds no good answer is tried weaker: at worst the bodies overlap for a moment.
void Crowd::push(std::size_t one, const Eigen::Vector2f& velocity) {
  Body& body = bodies_[one];
  if (body.rest_s > 0) return;
  const float bearing = wrapped(std::atan2(-velocity.y(), -velocity.x()) - body.facing);
  for (const float share : {1.0F, 0.75F, 0.5F}) {
    const Eigen::Vector3f asked(share * velocity.x(), share * velocity.y(), 0);
    if (characters_[one].push(place_of(bearing), asked, workspace_) != runtime::Status::ok)
      continue;
    ++tally_.answered;
    tally_.weaker += share < 1 ? 1 : 0;
    body.rest_s = kRestAfterPush_s;
    return;
  }
  ++tally_.refused;
  body.rest_s = kRestAfterRefusal_s;
}

}  // namespace flinch::crowd
