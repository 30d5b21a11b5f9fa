// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "models/response_costs.h"
#include "train/objective/cost.h"
#include "train/store/store.h"

namespace flinch::train {

/// Returns what the clips of a store cost by this model, for the selector's file: the model's
/// constants, and the work of each clip's response from each stance as the observations that begin
/// there measured it. Where none has a clip at a phase and time, the other phases at that time tell
/// it, then the nearest time, then the clip's reference response; that of another stance than idle
/// with what the clips measured from there take more than theirs on average. A stance in which no
/// observation begins has no table.
models::ResponseCosts response_costs(const StoreHeader& header,
                                     std::span<const Observation> observations,
                                     const CostModel& model);

}  // namespace flinch::train
