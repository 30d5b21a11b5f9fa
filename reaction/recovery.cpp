// SPDX-License-Identifier: MIT
#include "reaction/recovery.h"

#include <algorithm>

namespace flinch::reaction {
namespace {

constexpr double kFirstBlend_s = 0.26;
constexpr double kSecondBlend_s = 0.375;
constexpr double kQuarterWay = 0.5 - 0.17364817766693033;  // q: 1/2 - sin(10 degrees)
constexpr double kReturnBlend_s = kSecondBlend_s / (1 - kQuarterWay);

double eased(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

RecoveryWeights weights_at(const RecoverySchedule& schedule, double since_contact_s) noexcept {
  const double return_begin_s = simulation_end_s(schedule) - kQuarterWay * kReturnBlend_s;
  return {1 - eased((since_contact_s - schedule.simulation_only_s) / kFirstBlend_s),
          eased((since_contact_s - return_begin_s) / kReturnBlend_s)};
}

double simulation_end_s(const RecoverySchedule& schedule) noexcept {
  return schedule.simulation_only_s + kFirstBlend_s;
}

double duration_s(const RecoverySchedule& schedule) noexcept {
  return simulation_end_s(schedule) + kSecondBlend_s;
}

}  // namespace flinch::reaction
