// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace flinch::program {

/// The processors that this process may use, and those that whatever started it may use.
struct Processors {
  int own = 1;
  int launcher = 1;
  bool by_mpirun = false;  ///< whether Open MPI's mpirun started this process
};
/// Asks the operating system. Where it does not tell of the launcher, `launcher` equals `own`.
Processors count_processors();

/// Returns a note if this process was bound to fewer processors than its threads need, as mpirun
/// does by default for one or two processes (Open MPI 4): all threads then share one core. Empty
/// otherwise. `threads` is the number that was asked for, if any; without it, a process of mpirun
/// is expected to have its share among `local_size` processes of this machine.
std::string binding_note(const Processors& processors, std::optional<int> threads, int local_size);

}  // namespace flinch::program
