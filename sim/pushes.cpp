// SPDX-License-Identifier: MIT
#include "sim/pushes.h"

#include <algorithm>

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kDriveTime_s = 0.1;  // six times 1 / w of the joints' springs
constexpr double kBlowSpeed_mps = 0.1;
constexpr double kTouch_m = 1e-3;

double closing_speed(const MovingShape& first, const MovingShape& second, const Approach& near) {
  return -near.normal.dot(first.velocity_at(near.point) - second.velocity_at(near.point));
}

}  // namespace

void Pushes::begin_step(double time_s) {
  time_s_ = time_s;
  hit_now_ = {};
}

void Pushes::hit(Body body) {
  driven_until_s_[body] = time_s_ + kDriveTime_s;
  hit_now_[body] = true;
}

/// Once each, in a fixed order.
template <class Visit>
void Pushes::for_each_pair(Visit visit) const {
  if (std::none_of(motion::kBodies.begin(), motion::kBodies.end(),
                   [this](Body body) { return driven(body); })) {
    return;
  }
  for (Body first : motion::kBodies) {
    for (Body second : motion::kBodies) {
      if (second <= first || !plan_.may_touch[first][second]) continue;
      if (driven(first) || driven(second)) visit(first, second);
    }
  }
}

void Pushes::add(const Figure& figure, const motion::PerBody<MovingShape>& shapes,
                 Contacts& contacts) {
  motion::PerBody<double> driven_until_s = driven_until_s_;
  for_each_pair([&](Body first, Body second) {
    const Approach near = approach(shapes[first], shapes[second]);
    if (near.gap > kTouch_m) return;
    const bool blow = hit_now_[first] || hit_now_[second] ||
                      closing_speed(shapes[first], shapes[second], near) > kBlowSpeed_mps;
    contacts.add_push(figure.body(first), first, figure.body(second), second, near, blow);
    if (!blow) return;
    const double until_s = std::max(driven_until_s_[first], driven_until_s_[second]);
    driven_until_s[first] = std::max(driven_until_s[first], until_s);
    driven_until_s[second] = std::max(driven_until_s[second], until_s);
  });
  driven_until_s_ = driven_until_s;
}

bool Pushes::ahead(const motion::PerBody<MovingShape>& shapes, double horizon_s) const {
  bool found = false;
  for_each_pair([&](Body first, Body second) {
    const Approach near = approach(shapes[first], shapes[second]);
    const double closing = closing_speed(shapes[first], shapes[second], near);
    found |= closing > kBlowSpeed_mps && near.gap > kTouch_m && near.gap < closing * horizon_s;
  });
  return found;
}

}  // namespace flinch::sim
