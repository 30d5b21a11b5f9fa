// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "models/selector.h"

namespace flinch::models {

/// A number of a threat that is outside of the range that a selector was fitted to.
struct OutsideTraining {
  std::string_view name;  ///< such as "speed_mps", with its unit; angles in degrees
  double value = 0;
  features::ValueRange trained;
};

/// The numbers of a threat that are outside, in the order of features::KnownKind.
struct OutsideTrainings {
  std::array<OutsideTraining, 8> numbers;
  std::size_t count = 0;  ///< of `numbers`, 0 if none is outside

  const OutsideTraining* begin() const { return numbers.data(); }
  const OutsideTraining* end() const { return numbers.data() + count; }
};

/// Returns which numbers of a scenario no scenario that the selector was fitted to could have: the
/// radius, mass, speed and elevation at the impact, time to impact, reach and length of its kind,
/// or a kind that the selector does not know. The selector answers all the same, but nothing is
/// known of how well. A number is outside if it exceeds a range by a thousandth of the range's
/// larger end.
OutsideTrainings outside_training(const Selector& selector, const features::Scenario& scenario);

}  // namespace flinch::models
