// SPDX-License-Identifier: MIT
#include "features/ball.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "features/ball_clearance.h"

namespace flinch::features {

namespace {

/// How the rod is turned `time_s` later.
RodShape turned(RodShape rod, double time_s) {
  const double turns = rod.angular_velocity.norm();
  if (turns > 0)
    rod.axis =
        (Eigen::AngleAxisd(turns * time_s, rod.angular_velocity / turns) * rod.axis).normalized();
  return rod;
}

/// From the position to the point about which a rod turns.
Eigen::Vector3d to_pivot(const RodShape& rod) {
  return -rod.to_pivot_m * rod.axis;
}

// x_pivot(t) + (x - x_pivot) turned by w t.
Ball rod_at(const Ball& ball, double time_s) {
  const Eigen::Vector3d velocity = ball.pivot_velocity();
  const Eigen::Vector3d fall(0, 0, -ball.gravity_mps2);
  Ball later = ball;
  later.rod = turned(ball.rod, time_s);
  const Eigen::Vector3d arm = -to_pivot(later.rod);
  later.position =
      ball.position + to_pivot(ball.rod) + time_s * velocity + 0.5 * time_s * time_s * fall + arm;
  later.velocity = velocity + time_s * fall + ball.rod.angular_velocity.cross(arm);
  later.window = ball.window.at(time_s);
  return later;
}

/// The centre of the sphere, as which the rod is nearest to an outline.
Eigen::Vector3d nearest_centre(const Ball& rod, const motion::CollisionShape& outline) {
  const Eigen::Vector3d butt = rod.position - rod.rod.to_butt_m * rod.rod.axis;
  const Eigen::Vector3d tip = rod.position + rod.rod.to_tip_m * rod.rod.axis;
  return butt + motion::nearest_share(butt, tip, outline) * (tip - butt);
}

/// Draws a ball out into a rod, with the hands that hold it: from the point about which it turns to
/// the centre of mass that both have.
void make_rod(const Rod& from, Ball& ball) {
  const RodInertia inertia =
      inertia_of(from, static_cast<float>(ball.radius), static_cast<float>(ball.mass_kg));
  RodShape& rod = ball.rod;
  rod.axis = from.axis.cast<double>().normalized();
  rod.angular_velocity = from.angular_velocity.cast<double>();
  rod.angular_velocity -= rod.angular_velocity.dot(rod.axis) * rod.axis;
  rod.to_pivot_m = inertia.to_mass_m;
  rod.to_butt_m = double{from.to_butt_m} + inertia.to_mass_m;
  rod.to_tip_m = double{from.to_tip_m} - inertia.to_mass_m;
  rod.inertia_kgm2 = inertia.inertia_kgm2;
  const Eigen::Vector3d arm = -to_pivot(rod);
  ball.mass_kg = inertia.mass_kg;
  ball.position += arm;
  ball.velocity += rod.angular_velocity.cross(arm);
}

/// When a rod first reaches the ground while it can touch, at most kMaxFlight_s ahead; infinity if
/// it does not. Conservative advancement: no point of it falls faster than v_z + g T + its turning.
double time_of_ground(const Ball& rod) {
  constexpr double kMaxFlight_s = 10;  // the longest time to impact of a file of threats
  constexpr double kTolerance_m = 1e-4;
  const double horizon_s = std::min(rod.window.until_s, kMaxFlight_s);
  double time_s = std::max(rod.window.from_s, 0.0);
  while (time_s < horizon_s) {
    const Ball then = rod.at(time_s);
    const double height = lowest_point_m(then);
    if (height <= kTolerance_m) return time_s;
    const double rate = std::max(-then.pivot_velocity().z(), 0.0) + then.turning_mps();
    // height = rate t + g t^2 / 2
    const double root = std::sqrt(rate * rate + 2 * rod.gravity_mps2 * height);
    if (rate + root <= 0) break;
    time_s += 2 * height / (rate + root);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

Eigen::Vector3d Ball::position_at(double time_s) const {
  if (is_rod()) return rod_at(*this, time_s).position;
  return position + time_s * velocity -
         0.5 * gravity_mps2 * time_s * time_s * Eigen::Vector3d::UnitZ();
}

Eigen::Vector3d Ball::velocity_at(double time_s) const {
  if (is_rod()) return rod_at(*this, time_s).velocity;
  return velocity - gravity_mps2 * time_s * Eigen::Vector3d::UnitZ();
}

Ball Ball::at(double time_s) const {
  if (is_rod()) return rod_at(*this, time_s);
  Ball later = *this;
  later.position = position_at(time_s);
  later.velocity = velocity_at(time_s);
  later.window = window.at(time_s);
  return later;
}

Eigen::Vector3d Ball::velocity_of(const Eigen::Vector3d& point) const {
  return is_rod() ? velocity + rod.angular_velocity.cross(point - position) : velocity;
}

Eigen::Vector3d Ball::pivot_velocity() const {
  return is_rod() ? velocity + rod.angular_velocity.cross(to_pivot(rod)) : velocity;
}

double Ball::turning_mps() const {
  if (!is_rod()) return 0;
  return rod.angular_velocity.norm() *
         std::max(std::abs(rod.to_butt_m - rod.to_pivot_m), rod.to_tip_m + rod.to_pivot_m);
}

double Ball::bounding_radius() const {
  return radius + std::max(rod.to_butt_m, rod.to_tip_m);
}

double lowest_point_m(const Ball& ball) {
  const double up = ball.rod.axis.z();
  return ball.position.z() + std::min(-ball.rod.to_butt_m * up, ball.rod.to_tip_m * up) -
         ball.radius;
}

VelocityChange velocity_change(const Ball& ball, double inertia_kgm2,
                               const Eigen::Vector3d& impulse, const Eigen::Vector3d& moment) {
  if (!ball.is_rod()) return {impulse / ball.mass_kg, moment / inertia_kgm2};
  const Eigen::Vector3d across = moment - moment.dot(ball.rod.axis) * ball.rod.axis;
  return {impulse / ball.mass_kg, across / ball.rod.inertia_kgm2};
}

motion::Clearance clearance(const Ball& ball, const motion::CollisionShape& outline) {
  return clearance(ball.is_rod() ? nearest_centre(ball, outline) : ball.position, ball.radius,
                   outline);
}

double gap_at(const Ball& ball, double time_s, const motion::CollisionShape& outline) {
  if (!ball.is_rod()) return motion::gap(ball.position_at(time_s), ball.radius, outline);
  return motion::gap(nearest_centre(rod_at(ball, time_s), outline), ball.radius, outline);
}

Ball ball_of(const Threat& threat, double gravity_mps2) {
  Ball ball{threat.position.cast<double>(),
            threat.velocity.cast<double>(),
            static_cast<double>(threat.radius),
            static_cast<double>(threat.mass_kg),
            threat.falls && !threat.stroke ? gravity_mps2 : 0,
            threat.bounce,
            {},
            {}};
  if (threat.rod) make_rod(*threat.rod, ball);
  if (threat.stroke) {
    const double starts_in_s = double{threat.stroke->starts_in_s};
    if (threat.rod) {
      ball = ball.at(-starts_in_s);
    } else {
      ball.position -= starts_in_s * ball.velocity;
    }
    ball.window = {starts_in_s, starts_in_s + double{threat.stroke->lasts_s}};
  }
  if (threat.rod) ball.window.until_s = std::min(ball.window.until_s, time_of_ground(ball));
  return ball;
}

double moment_of_inertia(const Ball& ball) {
  return 2.0 / 3 * ball.mass_kg * ball.radius * ball.radius;
}

// z + v t - g t^2 / 2 = r + touch; at the later root the ball falls.
std::optional<double> time_of_bounce(const Ball& ball, double horizon_s, double touch_m) {
  if (ball.is_rod()) return std::nullopt;
  const double height = ball.position.z() - ball.radius - touch_m;
  const double rise = ball.velocity.z();
  if (ball.gravity_mps2 <= 0) {
    if (rise >= 0) return std::nullopt;
    const double time_s = std::max(-height / rise, 0.0);
    return time_s <= horizon_s ? std::optional(time_s) : std::nullopt;
  }
  const double discriminant = rise * rise + 2 * ball.gravity_mps2 * height;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double time_s = std::max((rise + root) / ball.gravity_mps2, 0.0);
  return time_s <= horizon_s ? std::optional(time_s) : std::nullopt;
}

}  // namespace flinch::features
