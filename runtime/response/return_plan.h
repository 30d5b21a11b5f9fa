// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/response/response.h"

namespace flinch::runtime {

/// Returns the foot that carries more weight in this pose, the support foot where it is not clear.
motion::Side weight_bearing_foot(const Response& response, const motion::Pose& pose);

/// Plans the way from the response's `end_s` back to the stance: the feet go one after the other,
/// the one that carries more weight last.
void plan_return(Response& response);

}  // namespace flinch::runtime
