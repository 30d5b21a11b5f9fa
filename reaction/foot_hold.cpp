// SPDX-License-Identifier: MIT
#include "reaction/foot_hold.h"

#include <algorithm>

#include "motion/rotation.h"

namespace flinch::reaction {
namespace {

using motion::Body;

constexpr double kFrequency = 60;  // rad/s, as the trainer's figure holds its feet
constexpr double kGrip = 0.8;      // friction of a sole, of the weight that it carries
constexpr double kGravity_mps2 = 9.81;
constexpr double kStandingHeight_m = 0.02;
constexpr double kStandingSpeed_mps = 0.15;

bool stands(const sim::BodyState& foot, const sim::MovingShape& outline) {
  if (foot.velocity.norm() > kStandingSpeed_mps) return false;
  const Eigen::Quaterniond turn = foot.orientation * outline.orientation;
  const Eigen::Vector3d centre = foot.position + foot.orientation * outline.centre;
  // The lowest corner: what the half extents reach downwards together.
  const Eigen::Vector3d down = turn.conjugate() * Eigen::Vector3d::UnitZ();
  return centre.z() - down.cwiseAbs().dot(outline.half_extents) < kStandingHeight_m;
}

}  // namespace

FootHold::FootHold(const sim::FigurePlan& plan, dWorldID world, sim::Figure& figure)
    : plan_(plan), figure_(figure) {
  constexpr std::array kFeet{Body::left_foot, Body::right_foot};
  for (std::size_t i = 0; i < kFeet.size(); ++i) {
    const dBodyID part = figure.body(kFeet[i]);
    feet_[i] = {kFeet[i], part, sim::make_linear_motor(world, part),
                sim::make_motor(world, part, nullptr, Eigen::Matrix3d::Identity())};
  }
  let_go();
}

// A pull beyond the grip is one of softer gains, as for the pelvis: the foot slides.
void FootHold::hold(const sim::ReferenceState& target, double step_s, double share) {
  std::array<bool, 2> standing{};
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    standing[i] = stands(target.body[feet_[i].body], plan_.outline[feet_[i].body]);
  }
  const auto count = static_cast<double>(
      std::max<std::ptrdiff_t>(1, std::count(standing.begin(), standing.end(), true)));
  const double grip_n = kGrip * kGravity_mps2 * plan_.mass_kg / count;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Foot& foot = feet_[i];
    set_held(foot, standing[i]);
    if (!standing[i]) continue;
    const sim::BodyState now = sim::state_of(foot.part);
    const sim::BodyState& wanted = target.body[foot.body];
    const Eigen::Vector3d shift = wanted.position - now.position;
    const Eigen::Vector3d turn =
        motion::rotation_vector(wanted.orientation * now.orientation.conjugate());
    const sim::Gains turning = sim::weakened(plan_.gains[foot.body], share);
    sim::Gains gains =
        sim::weakened(sim::critically_damped(plan_.mass_kg / count, kFrequency), share);
    const double force_n =
        (gains.stiffness * shift + gains.damping * (wanted.velocity - now.velocity)).norm();
    if (force_n > grip_n) {
      gains = {grip_n / force_n * gains.stiffness, grip_n / force_n * gains.damping};
    }
    for (int axis = 0; axis < 3; ++axis) {
      set_spring(foot.place, axis, gains, gains.stiffness * shift[axis], wanted.velocity[axis],
                 step_s, dJointSetLMotorParam);
      set_spring(foot.turning, axis, turning, turning.stiffness * turn[axis],
                 wanted.angular_velocity[axis], step_s, dJointSetAMotorParam);
    }
  }
}

void FootHold::let_go() {
  for (const Foot& foot : feet_) set_held(foot, false);
}

void FootHold::set_held(const Foot& foot, bool held) {
  const auto set = held ? dJointEnable : dJointDisable;
  set(foot.place);
  set(foot.turning);
  figure_.set_held(foot.body, held);
}

}  // namespace flinch::reaction
