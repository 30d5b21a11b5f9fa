// SPDX-License-Identifier: MIT
#include "lookahead/oracle/response_motion.h"

#include <algorithm>
#include <cmath>

#include "sim/work.h"

namespace flinch::lookahead {

namespace {

std::size_t interval_count(double duration_s, float rate_hz) {
  return static_cast<std::size_t>(std::ceil(duration_s * double{rate_hz}));
}

/// Returns the poses of a response at the library's rate, from perception to at least `duration_s`.
motion::Motion sampled(const runtime::Response& response, float rate_hz, double duration_s) {
  const std::size_t intervals = interval_count(duration_s, rate_hz);
  motion::Motion motion;
  motion.rate_hz = rate_hz;
  motion.poses.reserve(intervals + 1);
  for (std::size_t k = 0; k <= intervals; ++k)
    motion.poses.push_back(runtime::pose_at(response, static_cast<float>(k) / rate_hz));
  return motion;
}

/// The work of a response whose poses reach to its end.
double work_of(const runtime::PreparedLibrary& library, const runtime::Response& response,
               const motion::Motion& motion) {
  if (response.clip == library.library->idle) return 0;
  const auto pose_number = [&motion](float time_s) {
    return std::min(static_cast<std::size_t>(std::max(time_s, 0.0F) * motion.rate_hz),
                    motion.poses.size() - 1);
  };
  motion::Motion moving;
  moving.rate_hz = motion.rate_hz;
  moving.poses.assign(
      motion.poses.begin() + static_cast<std::ptrdiff_t>(pose_number(response.first_motion_s)),
      motion.poses.begin() +
          static_cast<std::ptrdiff_t>(pose_number(runtime::duration_s(response)) + 1));
  return sum(sim::mechanical_work(library.library->character, moving));
}

}  // namespace

ResponseMotion make_response_motion(const runtime::PreparedLibrary& library,
                                    const runtime::Response& response, double simulated_s) {
  const float rate_hz = library.library->rate_hz;
  ResponseMotion made;
  made.simulated_s = simulated_s;
  // Velocities up to the end need two more poses.
  const double needed_s = simulated_s + 2 / double{rate_hz};
  made.motion =
      sampled(response, rate_hz, std::max(needed_s, double{runtime::duration_s(response)}));
  made.work_j = work_of(library, response, made.motion);
  std::vector<motion::Pose>& poses = made.motion.poses;
  poses.resize(std::min(poses.size(), interval_count(needed_s, rate_hz) + 1));
  poses.shrink_to_fit();
  return made;
}

double response_work_j(const runtime::PreparedLibrary& library, const runtime::Response& response) {
  return work_of(
      library, response,
      sampled(response, library.library->rate_hz, double{runtime::duration_s(response)}));
}

}  // namespace flinch::lookahead
