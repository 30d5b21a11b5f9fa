// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/response/response.h"

namespace flinch::runtime {

/// Whether a character that is in its stance walks: it has to come to rest before a clip, and walks
/// on after it.
bool walks(const PreparedLibrary& library, const features::CharacterState& state,
           const Inertialization& inertialization);

/// A walking character goes on until shortly before the response's `begin_s`, and from then on
/// comes to rest: sets `leave_s`, `rest` and `inertialization`. The rest of the plan is that for
/// any character that rests in another pose.
void plan_leaving(Response& response);

/// Returns the foot that carries more weight in this pose, the support foot where it is not clear.
motion::Side weight_bearing_foot(const Response& response, const motion::Pose& pose);

/// Plans the way from the response's `end_s` back to the stance: the feet go one after the other,
/// the one that carries more weight last.
void plan_return(Response& response);

}  // namespace flinch::runtime
