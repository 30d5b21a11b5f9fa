// SPDX-License-Identifier: MIT
#include "reaction/foot_lock.h"

#include <algorithm>

#include "motion/rotation.h"
#include "reaction/balance.h"

namespace flinch::reaction {
namespace {

using motion::Body;

// Rad/s, natural frequency of the hold, the same as in training.
constexpr double kFootFrequency = 60;
constexpr double kSoleFriction = 0.8;  // friction coefficient of a sole
constexpr double kMaxStandingHeight_m = 0.02;
constexpr double kMaxStandingSpeed_mps = 0.15;

bool stands(const sim::BodyState& foot, const sim::MovingShape& outline) {
  if (foot.velocity.norm() > kMaxStandingSpeed_mps) return false;
  const Eigen::Quaterniond turn = foot.orientation * outline.orientation;
  const Eigen::Vector3d centre = foot.position + foot.orientation * outline.centre;
  // The lowest corner: the sum of the half extents' downward components.
  const Eigen::Vector3d down = turn.conjugate() * Eigen::Vector3d::UnitZ();
  return centre.z() - down.cwiseAbs().dot(outline.half_extents) < kMaxStandingHeight_m;
}

}  // namespace

FootLock::FootLock(const sim::FigureModel& figure_model, dWorldID world, sim::Figure& figure)
    : figure_model_(figure_model), figure_(figure) {
  constexpr std::array kFeet{Body::left_foot, Body::right_foot};
  for (std::size_t i = 0; i < kFeet.size(); ++i) {
    const dBodyID part = figure.body(kFeet[i]);
    feet_[i] = {kFeet[i], part, sim::make_linear_motor(world, part),
                sim::make_motor(world, part, nullptr, Eigen::Matrix3d::Identity())};
  }
  unlock();
}

// A force beyond the friction limit acts as softer gains do, as for the pelvis: the foot slides.
void FootLock::lock(const sim::ReferenceState& target, double step_s, double share) {
  std::array<bool, 2> standing{};
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    standing[i] = stands(target.body[feet_[i].body], figure_model_.outline[feet_[i].body]);
  }
  const auto count = static_cast<double>(
      std::max<std::ptrdiff_t>(1, std::count(standing.begin(), standing.end(), true)));
  const double max_force_n =
      kSoleFriction * features::kGravity_mps2 * figure_model_.mass_kg / count;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Foot& foot = feet_[i];
    set_locked(foot, standing[i]);
    if (!standing[i]) continue;
    const sim::BodyState now = sim::state_of(foot.part);
    const sim::BodyState& wanted = target.body[foot.body];
    const Eigen::Vector3d shift = wanted.position - now.position;
    const Eigen::Vector3d turn =
        motion::rotation_vector(wanted.orientation * now.orientation.conjugate());
    const sim::Gains angular = sim::scaled_gains(figure_model_.gains[foot.body], share);
    sim::Gains gains = sim::scaled_gains(
        sim::critically_damped(figure_model_.mass_kg / count, kFootFrequency), share);
    const double force_n =
        (gains.stiffness * shift + gains.damping * (wanted.velocity - now.velocity)).norm();
    if (force_n > max_force_n) {
      gains = {max_force_n / force_n * gains.stiffness, max_force_n / force_n * gains.damping};
    }
    for (int axis = 0; axis < 3; ++axis) {
      set_spring(foot.place, axis, gains, gains.stiffness * shift[axis], wanted.velocity[axis],
                 step_s, dJointSetLMotorParam);
      set_spring(foot.angular, axis, angular, angular.stiffness * turn[axis],
                 wanted.angular_velocity[axis], step_s, dJointSetAMotorParam);
    }
  }
}

void FootLock::unlock() {
  for (const Foot& foot : feet_) set_locked(foot, false);
}

void FootLock::set_locked(const Foot& foot, bool locked) {
  const auto set = locked ? dJointEnable : dJointDisable;
  set(foot.place);
  set(foot.angular);
  figure_.set_locked(foot.body, locked);
}

}  // namespace flinch::reaction
