// SPDX-License-Identifier: MIT
#pragma once

#include "features/random.h"
#include "motion/clip.h"
#include "runtime/push/push_search.h"

namespace flinch::train {

/// A pushed motion that can be judged: a character in a clip of its library is pushed and answers
/// with a response (Arikan et al. 2005, section 5.1). Vectors are in the frame of its facing.
struct PushExample {
  int state_clip = 0;  ///< what the character does
  float state_s = 0;   ///< when in that clip the push comes
  motion::Role place = motion::Role::chest;
  Eigen::Vector3f asked = Eigen::Vector3f::Zero();  ///< velocity of the pushed joint, m/s
  runtime::PushCandidate answer;                    ///< response and theta; its realism is not set
};

/// Draws an example: a character that stands or moves (three of five) or recovers from a push, a
/// horizontal push of 0.3 to 1.8 m/s at any place from any side, one of the widths, and a response:
/// any (one of two), or one of the quarter that needs the least deformation. F gives the rest.
/// There must be responses.
PushExample sample_example(const runtime::PushResponses& responses, features::Random& random);

/// The character's pose when the push comes, and `dt_s` before it.
struct PushedState {
  motion::Pose before;
  motion::Pose now;
  float dt_s;
};
PushedState state_of(const runtime::PushResponses& responses, const PushExample& example);

/// The example's response as a game would show it.
runtime::PushMotion motion_of(const runtime::PushResponses& responses, const PushExample& example);

/// How much of the clip is played before the push, s.
inline constexpr float kLeadIn_s = 0.25F;

/// When the push comes in what is played, s from its first pose.
float push_time_s(const PushExample& example);

/// The example at 60 Hz: the clip from kLeadIn_s before the push, then the response to its end.
motion::Motion played(const runtime::PushResponses& responses, const PushExample& example);

}  // namespace flinch::train
