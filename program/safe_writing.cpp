// SPDX-License-Identifier: MIT
#include "program/safe_writing.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

namespace flinch::program {

void make_writes_safe() {
  signal(SIGXFSZ, SIG_IGN);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // A new descriptor is the lowest that is free. Opened for reading, it refuses text.
    if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDONLY));
  }
}

}  // namespace flinch::program
