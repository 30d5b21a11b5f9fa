// SPDX-License-Identifier: MIT
#include "train/realism/push_example.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "motion/rotation.h"
#include "runtime/push/push_deformation.h"

namespace flinch::train {
namespace {

using runtime::PushResponses;

constexpr float kRate_hz = 60;
constexpr float kStep_s = 1.0F / 240;

bool is_everyday(const motion::Clip& clip) {
  return clip.purpose == motion::Purpose::idle ||
         (clip.purpose == motion::Purpose::anticipation && !clip.annotation);
}

/// An index below `count`, which is above 0.
std::size_t any_index(features::Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.index(count));
}

/// An index of those clips for which `is_wanted` returns true; the idle clip where there is none.
template <class IsWanted>
int any_clip(const database::ClipLibrary& library, features::Random& random, IsWanted is_wanted) {
  std::vector<int> clips;
  for (std::size_t i = 0; i < library.clips.size(); ++i) {
    if (is_wanted(library.clips[i])) clips.push_back(static_cast<int>(i));
  }
  return clips.empty() ? library.idle : clips[any_index(random, clips.size())];
}

float uniform(features::Random& random, float min, float max) {
  return static_cast<float>(random.uniform(double{min}, double{max}));
}

/// A response among the quarter that needs the least deformation.
std::size_t near_response(const PushResponses& responses, const PushExample& example,
                          features::Random& random) {
  std::vector<std::pair<float, std::size_t>> by_deformation;
  for (std::size_t i = 0; i < responses.responses.size(); ++i) {
    const auto candidate = runtime::deformed_candidate(responses, i, example.place, example.asked);
    by_deformation.emplace_back(candidate.deformation.norm(), i);
  }
  std::ranges::sort(by_deformation);
  return by_deformation[any_index(random, std::max<std::size_t>(by_deformation.size() / 4, 1))]
      .second;
}

}  // namespace

PushExample sample_example(const PushResponses& responses, features::Random& random) {
  const database::ClipLibrary& library = *responses.library->library;
  PushExample example;
  const bool is_recovering = random.uniform() < 0.4;
  example.state_clip = any_clip(library, random, [&](const motion::Clip& clip) {
    return is_recovering ? clip.push.has_value() : is_everyday(clip);
  });
  const motion::Clip& clip = library.clip(example.state_clip);
  const float first_s = is_recovering && clip.push ? clip.push->contact_s : kStep_s;
  example.state_s = uniform(random, first_s, std::max(clip.motion.duration_s(), 2 * kStep_s));
  example.place = motion::kPushPlaces[any_index(random, motion::kPushPlaces.size())];
  const float direction = uniform(random, -std::numbers::pi_v<float>, std::numbers::pi_v<float>);
  example.asked =
      uniform(random, 0.3F, 1.8F) * Eigen::Vector3f(std::cos(direction), std::sin(direction), 0);
  const std::size_t response = random.uniform() < 0.5
                                   ? any_index(random, responses.responses.size())
                                   : near_response(responses, example, random);
  example.answer = runtime::deformed_candidate(responses, response, example.place, example.asked);
  example.answer.taper = runtime::kTapers[any_index(random, runtime::kTapers.size())];
  return example;
}

PushedState state_of(const PushResponses& responses, const PushExample& example) {
  const motion::Motion& motion = responses.library->clip(example.state_clip).motion;
  return {motion::sample(motion, example.state_s - kStep_s),
          motion::sample(motion, example.state_s), kStep_s};
}

runtime::PushMotion motion_of(const PushResponses& responses, const PushExample& example) {
  const PushedState state = state_of(responses, example);
  const Eigen::Quaternionf facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(state.now));
  const auto response = static_cast<std::size_t>(example.answer.response);
  const runtime::PushDeformation deformation{example.place, example.answer.taper,
                                             facing * example.answer.deformation,
                                             responses.responses[response].rise_s};
  runtime::PushMotion motion = make_push_motion(responses, response, example.answer.turn,
                                                deformation, state.before, state.now, state.dt_s);
  match_velocity(facing * example.asked, motion);
  return motion;
}

float push_time_s(const PushExample& example) {
  return std::floor(std::min(kLeadIn_s, example.state_s) * kRate_hz) / kRate_hz;
}

motion::Motion played(const PushResponses& responses, const PushExample& example) {
  const motion::Motion& before = responses.library->clip(example.state_clip).motion;
  const runtime::PushMotion after = motion_of(responses, example);
  motion::Motion motion;
  motion.rate_hz = kRate_hz;
  const auto lead_in = static_cast<int>(std::lround(push_time_s(example) * kRate_hz));
  for (int k = -lead_in; k < 0; ++k)
    motion.poses.push_back(
        motion::sample(before, example.state_s + static_cast<float>(k) / kRate_hz));
  for (int k = 0; static_cast<float>(k) / kRate_hz <= after.duration_s; ++k)
    motion.poses.push_back(pose_at(after, static_cast<float>(k) / kRate_hz));
  return motion;
}

}  // namespace flinch::train
