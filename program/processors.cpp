// SPDX-License-Identifier: MIT
#include "program/processors.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace flinch::program {
namespace {

/// Returns the number of processors that a process may use (0: this one), or nothing if the
/// operating system does not tell.
std::optional<int> processors_of(pid_t process) {
  cpu_set_t mask;
  if (sched_getaffinity(process, sizeof mask, &mask) != 0) return std::nullopt;
  return CPU_COUNT(&mask);
}

}  // namespace

Processors count_processors() {
  Processors processors;
  processors.own = processors_of(0).value_or(1);
  processors.launcher = processors_of(getppid()).value_or(processors.own);
  processors.by_mpirun = std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr;
  return processors;
}

std::string binding_note(const Processors& processors, std::optional<int> threads, int local_size) {
  const int share = std::max(1, processors.launcher / local_size);
  const int expected = std::min(threads.value_or(processors.by_mpirun ? share : 1), share);
  if (processors.own >= expected) return "";
  const std::string cure =
      processors.by_mpirun ? "; give mpirun the option --bind-to none" : "; see taskset";
  return "this process is bound to " + std::to_string(processors.own) + " of " +
         std::to_string(processors.launcher) + " processors, where " + std::to_string(expected) +
         " threads could run" + cure;
}

}  // namespace flinch::program
