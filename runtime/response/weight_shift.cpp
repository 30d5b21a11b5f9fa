// SPDX-License-Identifier: MIT
#include "runtime/response/weight_shift.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "motion/support_polygon.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response_pose.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Side;

constexpr float kShiftBackDuration_s = 0.45F;  // from the shifted weight back
constexpr float kHoldBeforeLift_s = 0.04F;     // shifted, before a foot leaves the ground
constexpr float kHoldAfterLift_s = 0.025F;     // shifted, after it left

// How far a point is from being kMargin inside of a sole, on the way to the sole's middle. Whole
// steps of 1/4096 of that way hide what rounding does to the fraction, and with it to every later
// pose.
Eigen::Vector2f offset_to_sole(const Sole& sole, const Eigen::Vector2f& point) {
  constexpr float kMargin = 0.015F;      // m
  constexpr float kTolerance_m = 1e-4F;  // by which a point may be nearer to the edge
  constexpr float kSteps = 4096;
  if (motion::fraction_to_inside(kMargin - kTolerance_m, sole.hull, point, sole.middle) <= 0)
    return {0, 0};
  const float fraction = motion::fraction_to_inside(kMargin, sole.hull, point, sole.middle);
  return std::ceil(kSteps * fraction) / kSteps * (sole.middle - point);
}

// Finds the pelvis' way of a shift, one of the response's, that brings the centre of mass over the
// sole of a foot. A pelvis takes most of the body along; the feet stay, so it must go a little
// farther.
void solve_pelvis_shift(const Response& r, Side side, float lift_s, WeightShift& shift) {
  constexpr float kOvershoot = 1.17F;
  constexpr float kDipPerShift = 0.2F;     // knees give, and need not straighten suddenly
  constexpr float kMaxShiftSpeed = 1.35F;  // m/s, mean: what is lacking then is left to momentum
  constexpr int kIterations = 6;
  const PreparedLibrary& library = *r.library;
  const float max_distance_m = kMaxShiftSpeed * (shift.hold.begin_s - shift.interval.begin_s);
  shift.pelvis = Eigen::Vector3f::Zero();
  const Samples samples = samples_at(r, lift_s);
  const motion::Pose unshifted = blended(r, samples);
  const Legs legs = legs_of(r, samples, unshifted);
  for (int round = 0; round < kIterations; ++round) {
    motion::Pose pose = unshifted;
    const Eigen::Vector3f weight_shift = weight_shift_at(r, lift_s);
    if (must_place_feet(r, samples, weight_shift)) place_feet(r, legs, weight_shift, pose);
    const motion::JointFrames frames = motion::forward_kinematics(library.skeleton(), pose);
    const FootPose foot = motion::foot_pose(frames, side);
    const Eigen::Quaternionf heading =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
    const Eigen::Vector3f centre = motion::centre_of_mass(library.body_model, frames);
    const Eigen::Vector2f in_sole =
        (heading.conjugate() * horizontal(centre - foot.ankle)).head<2>();
    const Eigen::Vector2f missing = offset_to_sole(library.soles[side], in_sole);
    if (missing.norm() <= 0) break;
    shift.pelvis += kOvershoot * (heading * Eigen::Vector3f(missing.x(), missing.y(), 0));
    const float distance = horizontal(shift.pelvis).norm();
    if (distance > max_distance_m) shift.pelvis *= max_distance_m / distance;
    shift.pelvis.z() = -kDipPerShift * horizontal(shift.pelvis).norm();
  }
}

}  // namespace

void shift_weight(Response& r, std::size_t number, Side over, float lift_s, float begin_s,
                  float latest_s) {
  WeightShift& shift = r.shifts[number];
  shift.hold = {lift_s - kHoldBeforeLift_s, lift_s + kHoldAfterLift_s};
  shift.interval = {begin_s, std::min(lift_s + kShiftBackDuration_s, latest_s)};
  solve_pelvis_shift(r, over, lift_s, shift);
  if (shift.pelvis.isZero(0)) shift = {};
}

}  // namespace flinch::runtime
