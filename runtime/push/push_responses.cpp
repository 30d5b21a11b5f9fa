// SPDX-License-Identifier: MIT
#include "runtime/push/push_responses.h"

#include <algorithm>

#include "motion/rotation.h"

namespace flinch::runtime {
namespace {

PushResponse response_of(const PreparedLibrary& library, int index) {
  const motion::Clip& clip = library.clip(index);
  const motion::Motion& motion = clip.motion;
  const motion::Push& push = *clip.push;
  const motion::Skeleton& skeleton = library.skeleton();
  const float step_s = 1 / motion.rate_hz;
  PushResponse response;
  response.clip = index;
  response.contact_s = push.contact_s;
  response.rise_s = push.peak_s - push.contact_s;
  response.duration_s = motion.duration_s() - push.contact_s;
  const float now_s = std::max(push.contact_s, step_s);
  const motion::Pose contact = motion::sample(motion, now_s);
  response.facing = motion::facing(motion::sample(motion, push.contact_s));
  response.configuration =
      body_configuration(skeleton, motion::sample(motion, now_s - step_s), contact, step_s);
  const float from_s = std::max(push.peak_s - kClipVelocityInterval_s / 2, 0.0F);
  const float to_s = std::min(push.peak_s + kClipVelocityInterval_s / 2, motion.duration_s());
  const auto from = motion::forward_kinematics(skeleton, motion::sample(motion, from_s));
  const auto to = motion::forward_kinematics(skeleton, motion::sample(motion, to_s));
  const Eigen::Quaternionf into_facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), -response.facing);
  for (std::size_t i = 0; i < motion::kPushPlaces.size(); ++i) {
    const motion::Role place = motion::kPushPlaces[i];
    response.velocity[i] =
        into_facing * (to.position[place] - from.position[place]) / (to_s - from_s);
  }
  return response;
}

}  // namespace

std::size_t push_place_index(motion::Role place) {
  return static_cast<std::size_t>(std::ranges::find(motion::kPushPlaces, place) -
                                  motion::kPushPlaces.begin());
}

PushResponses prepare_push_responses(const PreparedLibrary& library) {
  PushResponses responses{&library, {}};
  const std::vector<motion::Clip>& clips = library.library->clips;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (clips[i].push) responses.responses.push_back(response_of(library, static_cast<int>(i)));
  }
  return responses;
}

}  // namespace flinch::runtime
