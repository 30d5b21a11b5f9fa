// SPDX-License-Identifier: MIT
#include "reaction/crowd/crowd.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace flinch::reaction {
namespace {

using motion::Role;

constexpr float kRadius_m = 0.24F;        // of a body that is seen as a disc
constexpr float kMinTouch_mps = 0.15F;    // slower bodies do not run into a wall, they sway
constexpr float kMinPush_mps = 0.5F;      // a touch moves people apart, however slow they are
constexpr float kMaxPush_mps = 1.3F;      // about the strongest of recorded pushes
constexpr float kRestAfterPush_s = 0.6F;  // hands and walls push for about as long
constexpr float kOnTheGround_s = 2;       // until who was knocked over gets up

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
             const CrowdOptions& options)
    : options_(options), skeleton_(library.clip_library().character.skeleton) {
  const auto data = make_reaction_data(library);
  const runtime::WalkArea area{Eigen::Vector2f::Zero(), options.half_side_m - kRadius_m};
  std::mt19937 random(static_cast<unsigned>(options.seed));
  const auto columns = static_cast<int>(std::ceil(std::sqrt(options.characters)));
  const float step_m = 2 * options.half_side_m / static_cast<float>(columns);
  for (int k = 0; k < options.characters; ++k) {
    ReactingCharacter character(library, data);
    const auto at = [&](int index) {
      return (static_cast<float>(index) + 0.5F) * step_m - options.half_side_m;
    };
    // mt19937's bits are the same everywhere; the distributions of the library are not.
    const float facing = static_cast<float>(random() % 360) * static_cast<float>(M_PI) / 180;
    const float idle_s = static_cast<float>(random() % 100) / 50;
    character.character().place({at(k % columns), at(k / columns)}, facing, idle_s);
    character.character().walk(graph, options.seed * 1000 + static_cast<std::uint64_t>(k), area);
    character.stop();  // physics moves nobody yet: pose() is the character's
    characters_.push_back(std::move(character));
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
  pushes_.clear();
  for (ReactingCharacter& character : characters_) character.update(dt_s);
  observe(dt_s);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    help_up(i, dt_s);
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
    if (!is_beyond || outward_mps < kMinTouch_mps) continue;
    if (body.rest_s <= 0) ++tally_.walls;
    Eigen::Vector2f inward = Eigen::Vector2f::Zero();
    inward[axis] = -side * std::clamp(outward_mps, kMinPush_mps, kMaxPush_mps);
    push(one, inward);
  }
}

void Crowd::push(std::size_t one, const Eigen::Vector2f& velocity) {
  Body& body = bodies_[one];
  if (body.rest_s > 0) return;
  const float bearing = wrapped(std::atan2(-velocity.y(), -velocity.x()) - body.facing);
  ReactingCharacter& character = characters_[one];
  if (character.push(place_of(bearing), {velocity.x(), velocity.y(), 0}) != runtime::Status::ok)
    return;  // it lies on the ground
  const bool is_physical = character.pose_source() == PoseSource::physics;
  ++(is_physical ? tally_.physical : tally_.answered);
  pushes_.push_back({one, body.chest, velocity, is_physical});
  body.rest_s = kRestAfterPush_s;
}

// Who was knocked over gets up by the offset spring alone: there is no clip of it.
void Crowd::help_up(std::size_t one, float dt_s) {
  ReactingCharacter& character = characters_[one];
  Body& body = bodies_[one];
  const bool lies = character.pose_source() == PoseSource::physics &&
                    character.reaction().phase() == ReactionPhase::knocked_over;
  if (lies && body.lying_s == 0) ++tally_.knocked_over;
  body.lying_s = lies ? body.lying_s + dt_s : 0;
  if (body.lying_s < kOnTheGround_s) return;
  const motion::Pose pose = character.pose();
  character.character().move_to(pose, pose, dt_s);
  character.stop();
  body.lying_s = 0;
}

}  // namespace flinch::reaction
