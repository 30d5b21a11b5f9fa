// SPDX-License-Identifier: MIT
// The servos of the thesis' character against closed forms: one joint at a time, the others fixed.
#include <gtest/gtest.h>

#include <cmath>

#include "motion/default_character.h"
#include "motion/rotation.h"
#include "sim/figure/waist_up.h"
#include "sim/tree/tree_scene.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kStep_s = 1e-4;

/// The left arm, outstretched, on a shoulder that is the only joint with freedom.
class OneJoint {
 public:
  explicit OneJoint(BodySet limp = 0)
      : figure_(motion::default_character(),
                {.figure = FigureKind::waist_up, .limp_joints = limp}) {
    for (const Body body : motion::kBodies)
      if (body != Body::left_upper_arm) figure_.kinds[body] = JointKind::fixed;
    for (Gains* hips : {&figure_.gains[Body::pelvis], &figure_.pelvis_gains})
      *hips = scaled_gains(*hips, 1e6);
    figure_.tree = tree_constants(figure_);
  }

  FigureModel& figure() { return figure_; }
  Gains& gains() { return figure_.gains[Body::left_upper_arm]; }
  ServoLaw& law() { return figure_.laws[Body::left_upper_arm]; }
  void update() { figure_.tree = tree_constants(figure_); }

  ReferenceState state(const Eigen::Vector3d& angles) const {
    motion::Pose pose = rest_pose(figure_.skeleton);
    pose.rotation[motion::Role::left_upper_arm] =
        joint_rotation(figure_.limits[Body::left_upper_arm], angles).cast<float>();
    return state_at_rest(figure_.skeleton, figure_.model, pose);
  }

  /// Inertia of the arm about an axis through the shoulder, kg·m².
  double inertia(const Eigen::Vector3d& axis) const {
    const ReferenceState rest = state(Eigen::Vector3d::Zero());
    const Eigen::Vector3d shoulder =
        rest.body[Body::left_upper_arm].position + joint_offset(figure_, Body::left_upper_arm);
    double sum = 0;
    for (const Body body : {Body::left_upper_arm, Body::left_forearm, Body::left_hand}) {
      const Eigen::Vector3d arm = rest.body[body].position - shoulder;
      sum += axis.dot(figure_.inertia[body] * axis) +
             double{figure_.model[body].mass_kg} * axis.cross(arm).squaredNorm();
    }
    return sum;
  }

  /// A rotation of the outstretched arm about its shoulder, rad/s.
  static void spin(ReferenceState& start, const FigureModel& figure, const Eigen::Vector3d& speed) {
    const Eigen::Vector3d shoulder =
        start.body[Body::left_upper_arm].position + joint_offset(figure, Body::left_upper_arm);
    for (const Body body : {Body::left_upper_arm, Body::left_forearm, Body::left_hand}) {
      start.body[body].angular_velocity = speed;
      start.body[body].velocity = speed.cross(start.body[body].position - shoulder);
    }
  }

  /// Calls `visit` with the time, the angles and the angular velocity after each step.
  template <class Visit>
  void run(const ReferenceState& start, const ReferenceState& target, double duration_s,
           double gravity_mps2, Visit visit) const {
    TreeScene scene(figure_, start, nullptr, gravity_mps2);
    for (double time_s = kStep_s; time_s < duration_s; time_s += kStep_s) {
      scene.clear_contacts();
      scene.step(target, kStep_s);
      const auto& bodies = scene.bodies();
      const Eigen::Quaterniond rotation =
          bodies[Body::chest].orientation.conjugate() * bodies[Body::left_upper_arm].orientation;
      visit(time_s, joint_angles(figure_.limits[Body::left_upper_arm], rotation),
            bodies[Body::left_upper_arm].angular_velocity);
    }
  }

 private:
  FigureModel figure_;
};

/// The solution of I x'' = -k x - c x' from x(0) and x'(0).
double oscillator(double inertia, const Gains& gains, double x, double speed, double time_s) {
  const double decay = gains.damping / (2 * inertia);
  const double square = gains.stiffness / inertia - decay * decay;
  const double rate = std::sqrt(std::abs(square));
  const double slope = speed + decay * x;
  const double waves = square > 0
                           ? x * std::cos(rate * time_s) + slope / rate * std::sin(rate * time_s)
                           : x * std::cosh(rate * time_s) + slope / rate * std::sinh(rate * time_s);
  return std::exp(-decay * time_s) * waves;
}

TEST(Servo, SwingsTheArmAsTheDampedOscillatorDoes) {
  for (const double damping_share : {1.0, 0.1}) {
    OneJoint joint;
    joint.gains().damping *= damping_share;
    joint.update();
    const Eigen::Vector3d goal(0, 0, -0.4);
    const double inertia = joint.inertia(Eigen::Vector3d::UnitZ());
    joint.run(joint.state({0, 0, 0}), joint.state(goal), 0.15, 0,
              [&](double time_s, const Eigen::Vector3d& angles, const Eigen::Vector3d&) {
                const double expected =
                    goal.z() + oscillator(inertia, joint.gains(), -goal.z(), 0, time_s);
                ASSERT_NEAR(angles.z(), expected, 0.02 * 0.4) << time_s;
                ASSERT_NEAR(angles.y(), 0, 1e-3);
              });
  }
}

TEST(Servo, OfTheShoulderIsCriticallyDamped) {
  OneJoint joint;
  const motion::JointFrames rest =
      forward_kinematics(joint.figure().skeleton, rest_pose(joint.figure().skeleton));
  const double inertia = composite_inertia(joint.figure(), rest, Body::left_upper_arm);
  const auto [stiffness, damping] = joint.gains();
  EXPECT_NEAR(damping, 2 * std::sqrt(stiffness * inertia), 1e-9 * damping);
  EXPECT_NEAR(stiffness / damping, 400.0 / 10, 1e-9 * 40);
}

// The bone's axis gets a tenth of the torque, as if its gains were a tenth. So light an axis creeps
// at k / k_d, whatever the share; with less damping it swings, and tells the share.
TEST(Servo, TwistIsDampedByItsShare) {
  for (const double damping_share : {1.0, 0.05}) {
    OneJoint joint;
    joint.gains().damping *= damping_share;
    joint.update();
    const Eigen::Vector3d goal(0, 0.5, 0);
    const Gains tenth{0.1 * joint.gains().stiffness, 0.1 * joint.gains().damping};
    const double inertia = joint.inertia(Eigen::Vector3d::UnitY());
    double largest = 0;
    joint.run(joint.state({0, 0, 0}), joint.state(goal), 0.1, 0,
              [&](double time_s, const Eigen::Vector3d& angles, const Eigen::Vector3d&) {
                const double expected = goal.y() + oscillator(inertia, tenth, -goal.y(), 0, time_s);
                ASSERT_NEAR(angles.y(), expected, 0.04 * 0.5) << time_s;
                largest = std::max(largest, angles.y());
              });
    EXPECT_EQ(largest > 1.1 * goal.y(), damping_share < 1);
  }
}

TEST(Servo, TwistDampingLeavesSwingAlone) {
  OneJoint damped;
  OneJoint whole;
  whole.law().twist_share = 1;
  whole.update();
  for (const Eigen::Vector3d& goal : {Eigen::Vector3d(0, 0, -0.9), Eigen::Vector3d(0.7, 0, 0)}) {
    std::vector<Eigen::Vector3d> path;
    damped.run(damped.state({0, 0, 0}), damped.state(goal), 0.05, 0,
               [&](double, const Eigen::Vector3d& angles, const Eigen::Vector3d&) {
                 path.push_back(angles);
               });
    std::size_t k = 0;
    whole.run(whole.state({0, 0, 0}), whole.state(goal), 0.05, 0,
              [&](double, const Eigen::Vector3d& angles, const Eigen::Vector3d&) {
                ASSERT_LT((angles - path[k++]).norm(), 2e-3);
              });
    EXPECT_GT(path.back().norm(), 0.3);
  }
}

TEST(Servo, EnergyFalls) {
  OneJoint joint;
  joint.gains().damping *= 0.1;
  joint.update();
  const Eigen::Vector3d goal(0.2, 0, -0.5);
  const double inertia = joint.inertia(Eigen::Vector3d::UnitZ());
  double before = std::numeric_limits<double>::infinity();
  double first = 0;
  joint.run(joint.state({0, 0, 0}), joint.state(goal), 0.2, 0,
            [&](double, const Eigen::Vector3d& angles, const Eigen::Vector3d& speed) {
              const Eigen::Quaterniond left =
                  joint_rotation(joint.figure().limits[Body::left_upper_arm], goal) *
                  joint_rotation(joint.figure().limits[Body::left_upper_arm], angles).conjugate();
              const double energy =
                  inertia * speed.squaredNorm() / 2 +
                  joint.gains().stiffness * motion::rotation_vector(left).squaredNorm() / 2;
              ASSERT_LT(energy, before * (1 + 1e-6));
              if (first == 0) first = energy;
              before = energy;
            });
  EXPECT_LT(before, 0.3 * first);
}

// At a limit k and k_d rise so that the damping ratio stays: the arm overshoots as the stiffer
// oscillator does.
TEST(Servo, HardLimitStopsTheArmAsTheStifferOscillatorDoes) {
  OneJoint joint;
  const Eigen::Vector3d limit(1.2, 0, 0);
  ReferenceState start = joint.state(limit);
  constexpr double kSpeed = 8;
  const ReferenceState target = start;
  const Eigen::Quaterniond turn =
      joint_rotation(joint.figure().limits[Body::left_upper_arm], limit);
  const Eigen::Vector3d shoulder = start.body[Body::left_upper_arm].position +
                                   turn * joint_offset(joint.figure(), Body::left_upper_arm);
  for (const Body body : {Body::left_upper_arm, Body::left_forearm, Body::left_hand}) {
    start.body[body].angular_velocity = kSpeed * Eigen::Vector3d::UnitX();
    start.body[body].velocity =
        kSpeed * Eigen::Vector3d::UnitX().cross(start.body[body].position - shoulder);
  }
  const Gains stiff{21 * joint.gains().stiffness, std::sqrt(21.0) * joint.gains().damping};
  const double inertia = joint.inertia(Eigen::Vector3d::UnitX());
  double most = 0;
  double expected = 0;
  joint.run(start, target, 0.02, 0,
            [&](double time_s, const Eigen::Vector3d& angles, const Eigen::Vector3d&) {
              most = std::max(most, angles.x() - limit.x());
              expected = std::max(expected, oscillator(inertia, stiff, 0, kSpeed, time_s));
            });
  EXPECT_NEAR(most, expected, 0.06 * expected);
  EXPECT_GT(most, 0.001);
}

TEST(Servo, ALimpJointTurnsFreely) {
  OneJoint joint(set_of(Body::left_upper_arm));
  ReferenceState start = joint.state({0, 0, 0});
  OneJoint::spin(start, joint.figure(), {0, 0, -4});
  joint.run(start, joint.state({0, 0, 1}), 0.2, 0,
            [&](double time_s, const Eigen::Vector3d& angles, const Eigen::Vector3d&) {
              ASSERT_NEAR(angles.z(), -4 * time_s, 0.005);
            });
}

// From rest, what the arm's weight loses in height is kinetic energy: I w^2 / 2 = sum m g dz.
TEST(Servo, ALimpArmFallsWithoutLoss) {
  OneJoint joint(set_of(Body::left_upper_arm));
  const ReferenceState start = joint.state({0, 0, 0});
  const double inertia = joint.inertia(Eigen::Vector3d::UnitX());
  double moment = 0;  // of the weights about the shoulder
  const double shoulder_y = (start.body[Body::left_upper_arm].position +
                             joint_offset(joint.figure(), Body::left_upper_arm))
                                .y();
  for (const Body body : {Body::left_upper_arm, Body::left_forearm, Body::left_hand})
    moment += double{joint.figure().model[body].mass_kg} * 9.81 *
              (start.body[body].position.y() - shoulder_y);
  double fell = 0;
  joint.run(start, start, 0.3, 9.81,
            [&](double, const Eigen::Vector3d& angles, const Eigen::Vector3d& speed) {
              fell = -angles.x();
              if (fell < 0.1) return;
              ASSERT_NEAR(inertia * speed.squaredNorm() / 2, moment * std::sin(fell),
                          0.03 * moment * std::sin(fell));
            });
  EXPECT_GT(fell, 0.5);
}

}  // namespace
}  // namespace flinch::sim
