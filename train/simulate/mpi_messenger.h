// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "train/simulate/messenger.h"

namespace flinch::train {

/// Returns the messenger of a process that mpirun (or srun) started as one of several, or nothing
/// for a process that was started alone, which then does not use MPI. Throws Error if one of
/// several processes was built without MPI, because each would take itself for the only one.
///
/// The processes of a run end together when each destroys its messenger. A process that destroys it
/// because of an exception does not wait, and the launcher ends the others.
std::unique_ptr<Messenger> make_messenger();

}  // namespace flinch::train
