// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "runtime/push/body_configuration.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {

/// A recorded response to a push.
struct PushResponse {
  int clip = 0;                     ///< index in the library
  float contact_s = 0;              ///< when the push begins, s of the clip
  float rise_s = 0;                 ///< from there until the pushed joint moves fastest
  float duration_s = 0;             ///< from the contact until the clip ends
  float facing = 0;                 ///< of the character at contact, in the clip, radians
  BodyConfiguration configuration;  ///< C^i: at contact
  /// The velocity at the peak of each of motion::kPushPlaces, in the frame of the facing at
  /// contact, m/s.
  std::array<Eigen::Vector3f, motion::kPushPlaces.size()> velocity{};
};

/// The responses of a library. Refers to the library, which must outlive it.
struct PushResponses {
  const PreparedLibrary* library = nullptr;
  std::vector<PushResponse> responses;  ///< one per clip with a push, in the library's order
};

/// The interval over which velocities of clips are measured, s.
inline constexpr float kClipVelocityInterval_s = 1.0F / 15;

/// The index of `place` in motion::kPushPlaces, which it must be one of.
std::size_t push_place_index(motion::Role place);

/// Prepares the responses of a library. Allocates.
PushResponses prepare_push_responses(const PreparedLibrary& library);

}  // namespace flinch::runtime
