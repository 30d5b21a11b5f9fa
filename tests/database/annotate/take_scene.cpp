// SPDX-License-Identifier: MIT
#include "tests/database/annotate/take_scene.h"

#include <algorithm>
#include <cmath>

#include "motion/default_character.h"

namespace flinch::tests {

float minimum_jerk(double time_s, double begin_s, double end_s) {
  const double x = std::clamp((time_s - begin_s) / (end_s - begin_s), 0.0, 1.0);
  return static_cast<float>(x * x * x * (10 + x * (6 * x - 15)));
}

float pulse(double time_s, double begin_s, double peak_s, double end_s) {
  return time_s < peak_s ? minimum_jerk(time_s, begin_s, peak_s)
                         : 1 - minimum_jerk(time_s, peak_s, end_s);
}

motion::Pose standing() {
  motion::Pose pose = motion::rest_pose(motion::default_character().skeleton);
  motion::set_arm(pose, motion::Side::left, {});
  motion::set_arm(pose, motion::Side::right, {});
  return pose;
}

database::Take take_of(double duration_s, const std::function<motion::Pose(double)>& pose_at) {
  database::Take take;
  take.source.path = "take.bvh";
  take.figure = motion::make_figure(motion::default_character());
  take.motion.rate_hz = 60;
  for (int k = 0; k <= std::lround(60 * duration_s); ++k) {
    take.motion.poses.push_back(pose_at(k / 60.0));
  }
  return take;
}

}  // namespace flinch::tests
