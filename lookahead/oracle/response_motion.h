// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response.h"

namespace flinch::lookahead {

/// A response as the simulation tracks it.
struct ResponseMotion {
  motion::Motion motion;  ///< from perception to the end of the simulation, at the library's rate
  double simulated_s = 0;
  double work_j = 0;  ///< of the whole response, also beyond `simulated_s`
};

/// Samples a valid response for a simulation of `simulated_s` from perception on.
ResponseMotion make_response_motion(const runtime::PreparedLibrary& library,
                                    const runtime::Response& response, double simulated_s);

/// The mechanical work of a valid response, J, from its first movement to the end of its return.
/// Idling costs nothing, because the character would do it anyway.
double response_work_j(const runtime::PreparedLibrary& library, const runtime::Response& response);

}  // namespace flinch::lookahead
