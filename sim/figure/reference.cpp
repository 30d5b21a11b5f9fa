// SPDX-License-Identifier: MIT
#include "sim/figure/reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::sim {
namespace {

using motion::Body;

motion::PerBody<BodyState> places(const motion::BodyModel& model,
                                  const motion::JointFrames& frames) {
  motion::PerBody<BodyState> result;
  for (Body body : motion::kBodies) {
    const motion::Role role = role_of(body);
    // Double precision from here on: the sum of the links must fit the joints better than float
    // allows.
    result[body].orientation = frames.orientation[role].cast<double>().normalized();
    result[body].position = frames.position[role].cast<double>() +
                            result[body].orientation * model[body].centre_of_mass.cast<double>();
  }
  return result;
}

}  // namespace

ReferenceState state_at_rest(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                             const motion::Pose& pose) {
  const motion::JointFrames frames = forward_kinematics(skeleton, pose);
  ReferenceState state;
  state.body = places(model, frames);
  for (Body body : motion::kBodies) {
    if (const auto parent = parent_of(body)) {
      const BodyState& holder = state.body[*parent];
      state.socket[body] = holder.orientation.conjugate() *
                           (frames.position[role_of(body)].cast<double>() - holder.position);
    }
  }
  return state;
}

Reference::Reference(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                     const motion::Motion& motion)
    : skeleton_(skeleton), model_(model), motion_(motion) {
  const std::size_t last = motion.poses.size() - 1;
  velocities_.resize(motion.poses.size());
  if (last == 0) return;
  std::array<motion::PerBody<BodyState>, 3> states;  // pose k is in element k modulo 3
  const auto place = [&](std::size_t k) {
    states[k % 3] = places(model, forward_kinematics(skeleton, motion.poses[k]));
  };
  place(0);
  for (std::size_t k = 0; k <= last; ++k) {
    if (k < last) place(k + 1);
    const std::size_t before = k > 0 ? k - 1 : k;
    const std::size_t after = std::min(k + 1, last);
    const double rate_hz =
        static_cast<double>(motion.rate_hz) / static_cast<double>(after - before);
    for (Body body : motion::kBodies) {
      const BodyState& from = states[before % 3][body];
      const BodyState& to = states[after % 3][body];
      const Eigen::Vector3d turn =
          motion::rotation_vector(to.orientation * from.orientation.conjugate());
      velocities_[k].linear[body] = (rate_hz * (to.position - from.position)).cast<float>();
      velocities_[k].angular[body] = (rate_hz * turn).cast<float>();
    }
  }
}

ReferenceState Reference::at(double time_s) const {
  ReferenceState state =
      state_at_rest(skeleton_, model_, sample(motion_, static_cast<float>(time_s)));
  const double position = std::max(time_s * static_cast<double>(motion_.rate_hz), 0.0);
  const auto index = static_cast<std::size_t>(position);
  if (index + 1 >= velocities_.size()) return state;  // at rest at the end and beyond
  const double weight = position - std::floor(position);
  const Velocities& from = velocities_[index];
  const Velocities& to = velocities_[index + 1];
  for (Body body : motion::kBodies) {
    state.body[body].velocity =
        (1 - weight) * from.linear[body].cast<double>() + weight * to.linear[body].cast<double>();
    state.body[body].angular_velocity =
        (1 - weight) * from.angular[body].cast<double>() + weight * to.angular[body].cast<double>();
  }
  return state;
}

}  // namespace flinch::sim
