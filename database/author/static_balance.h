// SPDX-License-Identifier: MIT
#pragma once

#include "database/author/pose_rules.h"

namespace flinch::database {

/// Which of figure 3.10's cases a braced pose is in.
enum class BalanceCase : std::uint8_t {
  balanced,        ///< 1: the wanted centre of mass is above the soles
  braced,          ///< 2: it was, but is not any more: the threat will push it back
  beyond_balance,  ///< 3: it was not to begin with, and bracing does not mend it
};

/// The terms of equation 3.3 between a pose and the pose of the rules before balance, m and
/// radians.
struct BalanceError {
  float centre_of_mass = 0;  ///< horizontal distance from where it is wanted, equation 3.2
  /// Sum of both wrists' distances; of hands on the back of the head, relative to the head.
  float hands = 0;
  float torso = 0;  ///< sum of the angles of pelvis, abdomen and chest
  float pelvis_height = 0;
  float feet = 0;  ///< sum of both ankles' distances

  float total() const { return centre_of_mass + hands + torso + pelvis_height + feet; }
};

/// The ten degrees of freedom.
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
  bool feet_reach = true;  ///< false: a foot could not reach its place and stops short of it
};

inline constexpr float kBraceDistance = 0.10F;  // m, toward the threat

/// The sustained, braced pose (Hermens 2006, section 3.3): both feet on the ground, the rules
/// applied, the centre of mass `brace_m` toward the threat. Minimises equation 3.3 over the ten
/// degrees of freedom by L-BFGS with midpoint differences of 0.01, starting over from `pose` at
/// every evaluation. A raised foot is first put down where it is, if the leg reaches the ground.
/// Throws Error for a danger that check_threat refuses. About a millisecond.
BalancedPose balanced_pose(const motion::Figure& figure, const motion::Pose& pose,
                           const AimedThreat& threat, const RuleControls& controls,
                           float brace_m = kBraceDistance);

inline constexpr float kSmoothing = 0.02F;  // m and radians, where distances turn round

/// The error of some variables and its gradient by midpoint differences, for the optimiser and for
/// tests. Of the gradient, 0 to 2 belong to the pelvis and 3 to 9 to the controls in their order.
class BalanceProblem {
 public:
  BalanceProblem(const motion::Figure& figure, const motion::Pose& pose, const AimedThreat& threat,
                 const RuleControls& controls, float brace_m);

  motion::Pose pose_of(const BalanceVariables& variables, bool* feet_reach = nullptr) const;
  /// With `smoothing` each distance d becomes sqrt(d^2 + r^2) - r, so that there is a gradient at
  /// 0.
  BalanceError error_of(const motion::Pose& pose, float smoothing = 0) const;
  /// Of the total with kSmoothing.
  std::array<float, 10> gradient(const BalanceVariables& variables, float offset) const;
  /// Where the search begins.
  BalanceVariables initial_guess(const RuleControls& controls) const;
  /// Whether the centre of mass was balanced before bracing, and where it is wanted.
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

/// The variables as a vector and back.
std::array<float, 10> to_array(const BalanceVariables& variables);
BalanceVariables from_array(const std::array<float, 10>& values);

}  // namespace flinch::database
