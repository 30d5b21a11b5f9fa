// SPDX-License-Identifier: MIT
#include "tests/bench/push_cases.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "runtime/push/push_deformation.h"

namespace flinch::bench {

using motion::Role;
using runtime::PushCandidate;
using runtime::PushMotion;

namespace {

State state_at(const PushStudy& study, const motion::Motion& motion, float time_s) {
  State state{motion::sample(motion, time_s - kStateStep_s), motion::sample(motion, time_s), {}};
  state.configuration =
      runtime::body_configuration(study.prepared.skeleton(), state.before, state.now, kStateStep_s);
  return state;
}

}  // namespace

std::vector<State> everyday_states(const PushStudy& study, std::size_t count) {
  std::vector<std::pair<const motion::Motion*, float>> times;
  for (const motion::Clip& clip : study.library.clips) {
    if (clip.purpose == motion::Purpose::push || clip.annotation) continue;
    for (float time_s = 0.1F; time_s < clip.motion.duration_s(); time_s += 0.1F)
      times.emplace_back(&clip.motion, time_s);
  }
  std::vector<State> states;
  for (std::size_t k = 0; k < count && !times.empty(); ++k) {
    const auto& [motion, time_s] = times[k * times.size() / count];
    states.push_back(state_at(study, *motion, time_s));
  }
  return states;
}

Eigen::Vector3f horizontal(float speed, float degrees) {
  const float direction = motion::radians(degrees);
  return speed * Eigen::Vector3f(std::cos(direction), std::sin(direction), 0);
}

float angle_deg(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return motion::degrees(std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0F, 1.0F)));
}

motion::JointFrames joints_of(const PushStudy& study, const motion::Pose& pose) {
  return motion::forward_kinematics(study.prepared.skeleton(), pose);
}

Eigen::Vector3f wanted_velocity(const State& state, const Eigen::Vector3f& asked) {
  return motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(state.now)) * asked;
}

PushMotion push_motion_for(const PushStudy& study, const State& state,
                           const PushCandidate& candidate, Role place, const Eigen::Vector3f& asked,
                           bool matches) {
  const auto response = static_cast<std::size_t>(candidate.response);
  const runtime::PushDeformation deformation{place, candidate.taper,
                                             wanted_velocity(state, candidate.deformation),
                                             study.responses.responses[response].rise_s};
  PushMotion motion = make_push_motion(study.responses, response, candidate.turn, deformation,
                                       state.before, state.now, kStateStep_s);
  if (matches) match_velocity(wanted_velocity(state, asked), motion);
  return motion;
}

std::optional<Answer> answer_of(const PushStudy& study, const runtime::PushModel& model,
                                const State& state, std::span<const PushCandidate> candidates,
                                Role place, const Eigen::Vector3f& asked, bool deforms) {
  const Eigen::Vector3f wanted = wanted_velocity(state, asked);
  const bool is_exact = !model.realism->theta;
  for (const PushCandidate& candidate : candidates) {
    if (!(candidate.realism > runtime::kGoodRealism)) break;
    const PushMotion motion =
        push_motion_for(study, state, candidate, place, asked, deforms && is_exact);
    if (!is_exact || runtime::is_faithful(peak_velocity(motion, wanted), wanted))
      return {{candidate, motion}};
  }
  return std::nullopt;
}

PushCandidate nearest_response(const PushStudy& study, const State& state, Role place,
                               const Eigen::Vector3f& asked) {
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t i) {
    return (study.responses.responses[i].configuration - state.configuration).squaredNorm();
  };
  for (std::size_t i = 1; i < study.responses.responses.size(); ++i) {
    if (distance(i) < distance(nearest)) nearest = i;
  }
  PushCandidate candidate = runtime::deformed_candidate(study.responses, nearest, place, asked,
                                                        {.deforms = false, .turns = false});
  candidate.taper = 1;
  return candidate;
}

double percent(std::size_t part, std::size_t whole) {
  return whole > 0 ? 100 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace flinch::bench
