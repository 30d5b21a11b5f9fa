// SPDX-License-Identifier: MIT
#include "database/export/export_check.h"

#include <algorithm>
#include <cmath>

#include "database/library/library_check.h"
#include "motion/error.h"

namespace flinch::database {

void check_exportable(const motion::Physique& character, const motion::Motion& motion) {
  if (const char* what = fault_of(character)) throw Error("", what);
  if (!std::isfinite(motion.rate_hz) || motion.rate_hz <= 0) {
    throw Error("", "the motion's rate is not above 0");
  }
  if (motion.poses.empty()) throw Error("", "the motion has no poses: there is nothing to write");
  const auto broken = std::ranges::find_if_not(
      motion.poses, [](const motion::Pose& pose) { return is_sound(pose); });
  if (broken != motion.poses.end()) {
    throw Error("", "pose " + std::to_string(broken - motion.poses.begin()) +
                        " of the motion has a number that is not finite or a rotation that is not "
                        "a unit one");
  }
}

}  // namespace flinch::database
