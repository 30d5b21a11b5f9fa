// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "motion/body.h"

namespace flinch::sim {

/// A set of bodies, one bit per body.
using BodySet = std::uint32_t;

inline constexpr BodySet kAllBodies = (BodySet{1} << motion::kBodyCount) - 1;

constexpr BodySet set_of(motion::Body body) {
  return BodySet{1} << static_cast<unsigned>(body);
}

constexpr bool contains(BodySet bodies, motion::Body body) {
  return (bodies & set_of(body)) != 0;
}

/// The bodies that follow `body` in the enumeration.
constexpr BodySet bodies_after(motion::Body body) {
  return kAllBodies & ~(2 * set_of(body) - 1);
}

/// Calls `visit` for each body of the set in ascending order, which is parents first.
template <class Visit>
void for_each_body(BodySet bodies, Visit visit) {
  for (; bodies != 0; bodies &= bodies - 1) {
    visit(motion::kBodies[static_cast<std::size_t>(std::countr_zero(bodies))]);
  }
}

}  // namespace flinch::sim
