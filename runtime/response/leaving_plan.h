// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/response/foot_plan.h"

namespace flinch::runtime {

/// How a character leaves a walk.

/// Whether a character that is in its stance walks: it has to come to rest before a clip, and walks
/// on after it.
bool walks(const PreparedLibrary& library, const features::CharacterState& state,
           const Inertialization& inertialization);

/// A walking character goes on until shortly before the response's `begin_s`, and from then on
/// comes to rest: sets `leave_s`, `rest`, `inertialization` and `landings`, and `support` unless
/// the clip needs its own. The rest of the plan is that for any character that rests in another
/// pose, on the feet that will stand.
void plan_leaving(Response& response);

/// Lets a foot that swings come down where the clip has it, which is laid on the support foot.
void land_beside(Response& response, const Start& start);

/// When the foot that is not the support may leave the ground, s after perception: the weight has
/// to shift first, or the support foot to land. A walker whose support foot is in front goes on
/// over it by itself.
float ready_to_lift_s(const Response& response);

}  // namespace flinch::runtime
