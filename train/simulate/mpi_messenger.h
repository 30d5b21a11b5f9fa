// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "train/simulate/messenger.h"

namespace flinch::train {

/// The messenger of a process that mpirun (or srun) started as one of several; nothing for one that
/// was started by itself, which then has nothing to do with MPI. Throws Error where one of several
/// was built without MPI: each would take itself for the only one.
///
/// The processes of a run end together when each destroys its messenger. One that does so because
/// of an exception leaves without them, and the launcher ends the others.
std::unique_ptr<Messenger> make_messenger();

}  // namespace flinch::train
