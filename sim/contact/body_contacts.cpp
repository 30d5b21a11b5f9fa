// SPDX-License-Identifier: MIT
#include "sim/contact/body_contacts.h"

#include <algorithm>
#include <limits>

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kDrivenTime_s = 0.1;  // six times 1 / w of the joints' springs
constexpr double kImpactSpeed_mps = 0.1;
// A joint that a blow sets in motion swings at most as far as it moves in kSwingTime_s, which is
// twice 1 / w; what it carries along moves less than kStrikeDistance_m.
constexpr double kSwingTime_s = 0.03;
constexpr double kStrikeDistance_m = 0.01;
constexpr double kPushTolerance_m = 1e-3;

double closing_speed(const MovingShape& first, const MovingShape& second,
                     const motion::Clearance& near) {
  return -near.normal.dot(first.velocity_at(near.point) - second.velocity_at(near.point));
}

// Let g be the gap between two bodies. Where they are nearest, that point is within r + g of either
// centre, r being the radius of the bounding sphere, so the bodies close by at most
//
//   V + W g,  V = |v_1 - v_2| + |w_1| r_1 + |w_2| r_2,  W = |w_1| + |w_2|.
//
// With g <= d + (V + W g) h it follows that g <= (d + V h) / (1 - W h).
double max_reachable_gap(const MovingShape& first, double first_radius_m, const MovingShape& second,
                         double second_radius_m, double distance_m, double horizon_s) {
  if (horizon_s <= 0) return distance_m;
  const double first_turn = first.angular_velocity.norm();
  const double second_turn = second.angular_velocity.norm();
  const double speed = (first.velocity - second.velocity).norm() + first_turn * first_radius_m +
                       second_turn * second_radius_m;
  const double share = 1 - (first_turn + second_turn) * horizon_s;
  return share > 0 ? (distance_m + speed * horizon_s) / share
                   : std::numeric_limits<double>::infinity();
}

/// Whether two bodies may come within `distance_m` after closing at their largest rate for the
/// horizon. Tests the bounding spheres against each other, then the bounding sphere of either
/// against the other's shape.
bool may_come_near(const MovingShape& first, double first_radius_m, const MovingShape& second,
                   double second_radius_m, double distance_m, double horizon_s) {
  const double max_gap =
      max_reachable_gap(first, first_radius_m, second, second_radius_m, distance_m, horizon_s);
  const double apart = first_radius_m + second_radius_m + max_gap;
  return (first.centre - second.centre).squaredNorm() <= apart * apart &&
         motion::gap(first.centre, first_radius_m, second) <= max_gap &&
         motion::gap(second.centre, second_radius_m, first) <= max_gap;
}

/// Returns the speed at which the two bodies approach each other in the reference motion, at their
/// nearest points, m/s; 0 if they separate.
double reference_closing_speed(const BodyState& first, const BodyState& second,
                               const motion::Clearance& near) {
  const Eigen::Vector3d relative = velocity_at(first, near.point) - velocity_at(second, near.point);
  return std::max(0.0, -near.normal.dot(relative));
}

}  // namespace

BodyContacts::BodyContacts(const FigureModel& figure_model) : figure_model_(figure_model) {
  found_.reserve(motion::kBodyCount * (motion::kBodyCount - 1) / 2);
}

void BodyContacts::restart() {
  found_.clear();
  time_s_ = 0;
  driven_until_s_ = {};
  received_ns_ = {};
  hit_now_ = {};
}

void BodyContacts::begin_step(double time_s) {
  time_s_ = time_s;
  hit_now_ = {};
  for (Body body : motion::kBodies) {
    if (!driven(body)) received_ns_[body] = 0;
  }
}

void BodyContacts::add_hit(Body body) {
  driven_until_s_[body] = time_s_ + kDrivenTime_s;
  hit_now_[body] = true;
}

BodySet BodyContacts::driven() const {
  BodySet bodies = 0;
  for (Body body : motion::kBodies) {
    if (driven(body)) bodies |= set_of(body);
  }
  return bodies;
}

/// Calls `visit` once for each pair, in a fixed order, and leaves out pairs that are too far apart
/// to touch within the horizon.
template <class Visit>
void BodyContacts::for_each_pair(const motion::PerBody<MovingShape>& shapes, double distance_m,
                                 double horizon_s, Visit visit) const {
  const BodySet all_driven = driven();
  if (all_driven == 0) return;
  for (Body first : motion::kBodies) {
    BodySet others = figure_model_.may_collide[first] & bodies_after(first);
    if (!driven(first)) others &= all_driven;
    for_each_body(others, [&](Body second) {
      if (may_come_near(shapes[first], figure_model_.outline_radius[first], shapes[second],
                        figure_model_.outline_radius[second], distance_m, horizon_s)) {
        visit(first, second);
      }
    });
  }
}

std::span<const BodyContact> BodyContacts::find(const motion::PerBody<MovingShape>& shapes,
                                                const ReferenceOnDemand& reference) {
  found_.clear();
  motion::PerBody<double> driven_until_s = driven_until_s_;
  for_each_pair(shapes, kPushTolerance_m, 0, [&](Body first, Body second) {
    const motion::Clearance near = clearance(shapes[first], shapes[second]);
    if (near.gap > kPushTolerance_m) return;
    const double free_closing =
        reference_closing_speed(reference.get().body[first], reference.get().body[second], near);
    const double closing = closing_speed(shapes[first], shapes[second], near);
    const bool is_impact =
        hit_now_[first] || hit_now_[second] || closing > free_closing + kImpactSpeed_mps;
    found_.push_back({first, second, near, free_closing, is_impact});
    if (!is_impact) return;
    const double until_s = std::max(driven_until_s_[first], driven_until_s_[second]);
    driven_until_s[first] = std::max(driven_until_s[first], until_s);
    driven_until_s[second] = std::max(driven_until_s[second], until_s);
  });
  driven_until_s_ = driven_until_s;
  return found_;
}

double BodyContacts::time_to_impact(const motion::PerBody<MovingShape>& shapes,
                                    const ReferenceOnDemand& reference, double horizon_s) const {
  double first_s = horizon_s;
  for_each_pair(shapes, 0, horizon_s, [&](Body first, Body second) {
    const motion::Clearance near = clearance(shapes[first], shapes[second]);
    if (near.gap <= kPushTolerance_m) return;
    const double closing = closing_speed(shapes[first], shapes[second], near);
    const double free_closing =
        reference_closing_speed(reference.get().body[first], reference.get().body[second], near);
    if (closing <= free_closing + kImpactSpeed_mps) return;
    first_s = std::min(first_s, near.gap / closing);
  });
  return first_s;
}

bool BodyContacts::may_collide_again(const motion::PerBody<MovingShape>& shapes) const {
  bool found = false;
  for_each_pair(shapes, kStrikeDistance_m, kSwingTime_s, [&](Body first, Body second) {
    const motion::Clearance near = clearance(shapes[first], shapes[second]);
    const double closing = closing_speed(shapes[first], shapes[second], near);
    found |= near.gap < kStrikeDistance_m + std::max(0.0, closing) * kSwingTime_s;
  });
  return found;
}

double BodyContacts::add_impulse(const ContactImpulse& contact, motion::PerBody<double>& impulse,
                                 double share) {
  const double impulse_ns = share * contact.impulse_ns;
  if (!contact.second) {
    impulse[contact.first] += impulse_ns;
    received_ns_[contact.first] += impulse_ns;
    return impulse_ns;
  }
  const bool first_gives = received_ns_[contact.first] >= received_ns_[*contact.second];
  const Body giver = first_gives ? contact.first : *contact.second;
  const Body taker = first_gives ? *contact.second : contact.first;
  const double passed = std::min(impulse_ns, received_ns_[giver]);
  impulse[giver] += passed;
  impulse[taker] += passed;
  received_ns_[giver] -= passed;
  received_ns_[taker] += passed;
  return passed;
}

}  // namespace flinch::sim
