// SPDX-License-Identifier: MIT
#include "database/author/static_balance.h"

#include <lbfgs.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/body_distance.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"

namespace flinch::database {

using motion::JointFrames;
using motion::Pose;
using motion::Role;
using motion::rotation_about;
using motion::Side;

namespace {

constexpr float kOffset = 0.01F;  // step of the central differences, as in the thesis
constexpr int kMaxIterations = 7;
// Units of the optimiser's variables, so that one unit of each has a similar effect.
constexpr std::array<float, 10> kUnits{0.1F,  0.1F,  0.1F,  0.25F, 0.25F,
                                       0.25F, 0.25F, 0.25F, 0.25F, 0.25F};

// Angle between two orientations: 2 asin of half the distance of the unit quaternions.
float angle_between(const Eigen::Quaternionf& a, const Eigen::Quaternionf& b) {
  return 2 * std::asin(std::min((a.conjugate() * b).vec().norm(), 1.0F));
}

// Both feet flat on the ground, below where they are.
motion::PerSide<motion::FootPose> planted_feet(const motion::Figure& figure,
                                               const JointFrames& frames) {
  motion::PerSide<motion::FootPose> feet;
  for (Side side : motion::kSides) {
    motion::FootPose& place = feet[side];
    place = foot_pose(frames, side);
    place.ankle.z() = motion::measure_foot(figure.skeleton(), side).ankle_height;
    place.orientation = rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(place.orientation));
  }
  return feet;
}

// Where the hip is too high for the leg to reach the ground, the foot stays in the air (section
// 3.3).
Pose planted(const motion::Figure& figure, const Pose& pose) {
  const JointFrames frames = motion::forward_kinematics(figure.skeleton(), pose);
  motion::PerSide<motion::FootPose> feet = planted_feet(figure, frames);
  for (Side side : motion::kSides) {
    const motion::LimbRoles roles = motion::roles_of(leg_of(side));
    const motion::FootPose& place = feet[side];
    const float needed = (place.ankle - frames.position[roles.upper]).norm();
    const float length = motion::limb_length(figure.skeleton(), leg_of(side));
    if (needed > length) feet[side] = foot_pose(frames, side);
  }
  return with_feet(figure.skeleton(), pose, feet);
}

struct OptimiserState {
  const BalanceProblem* problem;
  int iterations = 0;
  bool is_finite = true;  ///< every error and slope so far
};

lbfgsfloatval_t evaluate(void* instance, const lbfgsfloatval_t* x, lbfgsfloatval_t* gradient,
                         const int /*n*/, const lbfgsfloatval_t /*step*/) {
  auto& run = *static_cast<OptimiserState*>(instance);
  const BalanceProblem& problem = *run.problem;
  std::array<float, 10> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(x[i]) * kUnits[i];
  const BalanceVariables variables = from_array(values);
  const std::array<float, 10> slope = problem.gradient(variables, kOffset);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    gradient[i] = slope[i] * kUnits[i];
    run.is_finite &= std::isfinite(gradient[i]);
  }
  const float error = problem.error_of(problem.pose_of(variables), kSmoothing).total();
  run.is_finite &= std::isfinite(error);
  return error;
}

int count_iterations(void* instance, const lbfgsfloatval_t*, const lbfgsfloatval_t*,
                     const lbfgsfloatval_t, const lbfgsfloatval_t, const lbfgsfloatval_t,
                     const lbfgsfloatval_t, int, int iteration, int) {
  auto& run = *static_cast<OptimiserState*>(instance);
  run.iterations = iteration;
  return run.is_finite ? 0 : LBFGS_STOP;
}

}  // namespace

std::array<float, 10> to_array(const BalanceVariables& variables) {
  const RuleControls& c = variables.controls;
  const Eigen::Vector3f& shift = variables.pelvis_shift;
  return {shift.x(),
          shift.y(),
          shift.z(),
          c.lean,
          c.turn,
          c.recoil,
          c.reach[motion::Side::left],
          c.reach[motion::Side::right],
          c.swivel[motion::Side::left],
          c.swivel[motion::Side::right]};
}

BalanceVariables from_array(const std::array<float, 10>& values) {
  BalanceVariables variables;
  variables.pelvis_shift = {values[0], values[1], values[2]};
  variables.controls = {
      values[3], values[4], values[5], {values[6], values[7]}, {values[8], values[9]}};
  return variables;
}

BalanceProblem::BalanceProblem(const motion::Figure& figure, const Pose& pose,
                               const AimedThreat& threat, const RuleControls& controls,
                               float brace_m)
    : figure_(figure),
      start_(planted(figure, pose)),
      geometry_(threat_geometry(figure, start_, threat)) {
  const motion::Skeleton& skeleton = figure.skeleton();
  const JointFrames frames = motion::forward_kinematics(skeleton, start_);
  feet_ = {foot_pose(frames, Side::left), foot_pose(frames, Side::right)};
  const Pose unbalanced = pose_of({Eigen::Vector3f::Zero(), controls});
  reference_ = motion::forward_kinematics(skeleton, unbalanced);
  hands_on_head_ = guards_head_from_behind(reference_, geometry_);
  const Eigen::Vector2f centre = motion::centre_of_mass(figure.bodies, reference_).head<2>();
  Eigen::Vector2f toward = (threat.threat.position - threat.target_point).head<2>();
  // a threat from straight above gives no direction to lean in
  if (toward.norm() > 0) toward.normalize();
  goal_ = centre + brace_m * toward;
  balanced_before_ =
      motion::signed_distance_inside(motion::support_polygon(skeleton, reference_), centre) >= 0;
}

Pose BalanceProblem::pose_of(const BalanceVariables& variables, bool* feet_reach) const {
  Pose moved = start_;
  moved.root_position += variables.pelvis_shift;
  return apply_rules(figure_, moved, geometry_, variables.controls, feet_, feet_reach);
}

BalanceError BalanceProblem::error_of(const Pose& pose, float smoothing) const {
  const JointFrames frames = motion::forward_kinematics(figure_.skeleton(), pose);
  const auto smoothed = [smoothing](float distance) {
    return std::sqrt(distance * distance + smoothing * smoothing) - smoothing;
  };
  const auto moved = [&](Role role) {
    return smoothed((frames.position[role] - reference_.position[role]).norm());
  };
  const auto hand = [&](Role role) {
    if (!hands_on_head_) return moved(role);
    const Eigen::Vector3f now = frames.position[role] - frames.position[Role::head];
    const Eigen::Vector3f then = reference_.position[role] - reference_.position[Role::head];
    return smoothed((now - then).norm());
  };
  const auto turned = [&](Role role) {
    return smoothed(angle_between(frames.orientation[role], reference_.orientation[role]));
  };
  const Eigen::Vector2f centre = motion::centre_of_mass(figure_.bodies, frames).head<2>();
  const float rise = frames.position[Role::pelvis].z() - reference_.position[Role::pelvis].z();
  return {smoothed((centre - goal_).norm()), hand(Role::left_hand) + hand(Role::right_hand),
          turned(Role::pelvis) + turned(Role::abdomen) + turned(Role::chest), smoothed(rise),
          moved(Role::left_foot) + moved(Role::right_foot)};
}

std::array<float, 10> BalanceProblem::gradient(const BalanceVariables& variables,
                                               float offset) const {
  const std::array<float, 10> middle = to_array(variables);
  std::array<float, 10> slope{};
  for (std::size_t i = 0; i < slope.size(); ++i) {
    const auto error_at = [&](float value) {
      std::array<float, 10> values = middle;
      values[i] = value;
      return error_of(pose_of(from_array(values)), kSmoothing).total();
    };
    slope[i] = (error_at(middle[i] + offset) - error_at(middle[i] - offset)) / (2 * offset);
  }
  return slope;
}

// The pelvis moves by the missing shift of the centre of mass plus a sixth, for the parts that do
// not move with it; hands on the threat's line are drawn in by as much as this moves them along it.
// Where that is no better than not moving, the guess is not to move.
BalanceVariables BalanceProblem::initial_guess(const RuleControls& controls) const {
  const BalanceVariables stay{Eigen::Vector3f::Zero(), controls};
  const Eigen::Vector2f centre = motion::centre_of_mass(figure_.bodies, reference_).head<2>();
  const Eigen::Vector2f shift = 1.17F * (goal_ - centre);
  BalanceVariables guess{{shift.x(), shift.y(), 0}, controls};
  if (!hands_on_head_) {
    const float closer =
        shift.dot(geometry_.to_threat.head<2>()) / reach_range(figure_, geometry_.weights);
    for (float& reach : guess.controls.reach) reach = std::clamp(reach + closer, 0.0F, 1.0F);
  }
  const auto error = [this](const BalanceVariables& variables) {
    return error_of(pose_of(variables), kSmoothing).total();
  };
  return error(guess) < error(stay) ? guess : stay;
}

BalanceCase BalanceProblem::balance_of(const Pose& pose) const {
  const JointFrames frames = motion::forward_kinematics(figure_.skeleton(), pose);
  const bool balanced =
      motion::signed_distance_inside(motion::support_polygon(figure_.skeleton(), frames),
                                     motion::centre_of_mass(figure_.bodies, frames).head<2>()) >= 0;
  if (balanced) return BalanceCase::balanced;
  return balanced_before_ ? BalanceCase::braced : BalanceCase::beyond_balance;
}

// If it stops at the iteration limit, or the line search for lack of progress, x still holds the
// best point. These codes are the highest of the negative ones, but for one.
void check_optimiser_code(int code) {
  const bool has_best_point = code >= LBFGS_SUCCESS || code >= LBFGSERR_OUTOFINTERVAL;
  if (!has_best_point || code == LBFGSERR_INVALIDPARAMETERS) {
    throw Error("", "the optimiser of balance failed with code " + std::to_string(code) +
                        " of liblbfgs; this is a fault of the program, please report it");
  }
}

// liblbfgs (Okazaki's C port of Nocedal's L-BFGS): small, quasi-Newton as in the thesis, and
// deterministic.
void check_threat(const motion::Figure& figure, const Pose& pose, const AimedThreat& aimed) {
  const features::Threat& threat = aimed.threat;
  const float speed_mps = threat.velocity.norm();
  if (!(speed_mps > 0) || !std::isfinite(speed_mps)) {
    throw Error("", "the threat's speed must be a positive number of metres per second");
  }
  if (!threat.position.allFinite() || !aimed.target_point.allFinite() || !(threat.radius > 0) ||
      !std::isfinite(threat.radius)) {
    throw Error("", "the threat's position, target point and radius must be finite numbers");
  }
  const JointFrames frames = motion::forward_kinematics(figure.skeleton(), pose);
  if (distance_to_figure(figure, frames, threat.position) < threat.radius) {
    throw Error("", "the threat starts inside the body: start it farther away");
  }
  if ((threat.position - aimed.target_point).norm() < 1e-3F) {
    throw Error("", "the threat starts at its target point: start it farther away");
  }
}

BalancedPose balanced_pose(const motion::Figure& figure, const Pose& pose,
                           const AimedThreat& threat, const RuleControls& controls, float brace_m) {
  check_threat(figure, pose, threat);
  const BalanceProblem problem(figure, pose, threat, controls, brace_m);
  std::array<lbfgsfloatval_t, 10> x{};
  const std::array<float, 10> start = to_array(problem.initial_guess(controls));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = start[i] / kUnits[i];

  lbfgs_parameter_t parameters;
  lbfgs_parameter_init(&parameters);
  parameters.max_iterations = kMaxIterations;
  parameters.max_linesearch = 10;
  parameters.epsilon = 1e-3;
  parameters.past = 3;
  parameters.delta = 2e-3;
  OptimiserState run{&problem, 0};
  const int code = lbfgs(static_cast<int>(x.size()), x.data(), nullptr, evaluate, count_iterations,
                         &run, &parameters);
  check_optimiser_code(code);
  // With a gradient that is not a number, liblbfgs returns LBFGS_ALREADY_MINIMIZED.
  if (!run.is_finite) {
    throw Error("",
                "the pose cannot be balanced, because its error is not a finite number; check "
                "the numbers of the character, the pose, the controls and the threat");
  }

  std::array<float, 10> found{};
  for (std::size_t i = 0; i < x.size(); ++i) found[i] = static_cast<float>(x[i]) * kUnits[i];
  BalancedPose result;
  result.variables = from_array(found);
  result.pose = problem.pose_of(result.variables, &result.feet_reach);
  result.error = problem.error_of(result.pose);
  result.iterations = run.iterations;
  result.balance = problem.balance_of(result.pose);
  return result;
}

}  // namespace flinch::database
