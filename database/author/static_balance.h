// SPDX-License-Identifier: MIT
#pragma once

#include "database/rules/pose_rules.h"

namespace flinch::database {

/// The case of figure 3.10 that a braced pose is in.
enum class BalanceCase : std::uint8_t {
  balanced,        ///< 1: the goal of the centre of mass is above the soles
  braced,          ///< 2: bracing moved it out of balance: the threat will push it back
  beyond_balance,  ///< 3: out of balance before bracing, and still so
};

/// The terms of equation 3.3 for a pose, relative to the pose that the rules give before balance, m
/// and radians.
struct BalanceError {
  float centre_of_mass = 0;  ///< horizontal distance from its goal, equation 3.2
  /// Sum of both wrists' distances; for hands on the back of the head, relative to the head.
  float hands = 0;
  float torso = 0;  ///< sum of the angles of pelvis, abdomen and chest
  float pelvis_height = 0;
  float feet = 0;  ///< sum of both ankles' distances

  float total() const { return centre_of_mass + hands + torso + pelvis_height + feet; }
};

/// The ten degrees of freedom of the optimisation.
struct BalanceVariables {
  Eigen::Vector3f pelvis_shift = Eigen::Vector3f::Zero();  ///< m, before the feet are planted
  RuleControls controls;
};

struct BalancedPose {
  motion::Pose pose;
  BalanceVariables variables;
  BalanceError error;
  int iterations = 0;
  BalanceCase balance = BalanceCase::balanced;
  bool feet_reach = true;  ///< false: a foot's target was out of reach
};

/// Throws Error for a speed that is not positive and finite, or a position that is not finite, or
/// inside the body in this pose, or at the target point.
void check_threat(const motion::Figure& figure, const motion::Pose& pose,
                  const AimedThreat& threat);

/// Returns the sustained, braced pose (Hermens 2006, section 3.3): both feet on the ground, the
/// rules applied, the centre of mass moved by `brace_m` towards the threat. Minimises equation 3.3
/// over the ten degrees of freedom by L-BFGS with central differences of 0.01; every evaluation
/// starts again from `pose`. A raised foot is first put down below where it is, if the leg reaches
/// the ground. Throws Error for a threat that check_threat rejects and where the error or its
/// gradient is not a finite number. Takes about a millisecond.
BalancedPose balanced_pose(const motion::Figure& figure, const motion::Pose& pose,
                           const AimedThreat& threat, const RuleControls& controls,
                           float brace_m = kBraceDistance);

inline constexpr float kSmoothing = 0.02F;  // m and radians, smooths distances near 0

/// Error of given variables and its gradient by central differences, for the optimiser and for
/// tests. Gradient elements 0 to 2 belong to the pelvis, 3 to 9 to the controls in their order.
class BalanceProblem {
 public:
  BalanceProblem(const motion::Figure& figure, const motion::Pose& pose, const AimedThreat& threat,
                 const RuleControls& controls, float brace_m);

  motion::Pose pose_of(const BalanceVariables& variables, bool* feet_reach = nullptr) const;
  /// With `smoothing` r, each distance d becomes sqrt(d^2 + r^2) - r, which is differentiable at 0.
  BalanceError error_of(const motion::Pose& pose, float smoothing = 0) const;
  /// Gradient of the total with kSmoothing.
  std::array<float, 10> gradient(const BalanceVariables& variables, float offset) const;
  /// Returns the start of the search.
  BalanceVariables initial_guess(const RuleControls& controls) const;
  /// Returns the case for a pose, from its balance before bracing and in `pose`.
  BalanceCase balance_of(const motion::Pose& pose) const;

 private:
  const motion::Figure& figure_;
  motion::Pose start_;
  ThreatGeometry geometry_;
  motion::PerSide<motion::FootPose> feet_;
  motion::JointFrames reference_;
  Eigen::Vector2f goal_;
  bool balanced_before_ = true;
  bool hands_on_head_ = false;
};

/// Throws Error for a return code of lbfgs() that leaves no best point: not enough memory, or
/// parameters that it refuses.
void check_optimiser_code(int code);

/// Converts the variables to an array.
std::array<float, 10> to_array(const BalanceVariables& variables);
BalanceVariables from_array(const std::array<float, 10>& values);

}  // namespace flinch::database
