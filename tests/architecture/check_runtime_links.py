#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails when the run time links, or calls, what a game must not be made to carry.

Usage: check_runtime_links.py TARGETS MODULE [LIBRARY...]

TARGETS names a file of the CMake targets that a game links, directly or not, one a line.
MODULE is a shared object that holds the whole of these. LIBRARY is a further library it may need
(a sanitizer's).
"""

import subprocess
import sys
from pathlib import Path

ALLOWED_TARGETS = {"flinch_flags", "flinch_motion", "flinch_features", "flinch_database_library",
                   "flinch_database_rules",
                   "flinch_models", "flinch_sim", "flinch_sim_collision", "flinch_sim_figure",
                   "flinch_sim_contact", "flinch_sim_tree", "flinch_sim_encounter",
                   "flinch_runtime_response", "flinch_runtime_graph", "flinch_runtime_push",
                   "flinch_runtime",
                   "flinch_reaction", "flinch_lookahead", "flinch_c", "Eigen3::Eigen"}
ALLOWED_LIBRARIES = {"libstdc++.so", "libm.so", "libgcc_s.so", "libc.so", "ld-linux-x86-64.so",
                     "ld-linux-aarch64.so"}
# No sockets, threads, clocks or random numbers, no output to the terminal, no termination of the
# process.
FORBIDDEN_SYMBOLS = {
    "socket", "connect", "bind", "listen", "accept", "fork", "execve", "execvp", "system", "popen",
    "dlopen", "pthread_create", "thrd_create", "_ZNSt6thread15_M_start_threadESt10unique_ptrINS_6"
    "_StateESt14default_deleteIS1_EEPFvvE", "clock_gettime", "gettimeofday", "time",
    "_ZNSt6chrono3_V212steady_clock3nowEv", "_ZNSt6chrono3_V212system_clock3nowEv", "rand", "srand",
    "random", "_ZNSt13random_device9_M_getvalEv", "printf", "puts", "putchar", "setlocale",
    "_ZSt4cout", "_ZSt4cerr", "exit", "_exit", "quick_exit"}


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed_libraries(module: Path):
    for line in output_of("readelf", "--dynamic", "--wide", str(module)).splitlines():
        if "(NEEDED)" in line:
            yield line.split("[")[1].rstrip("]")


def called_symbols(module: Path):
    lines = output_of("nm", "--dynamic", "--undefined-only", str(module)).splitlines()
    return {line.split()[-1].split("@")[0] for line in lines}


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    module = Path(sys.argv[2])
    targets = Path(sys.argv[1]).read_text(encoding="utf-8").split()
    libraries = list(needed_libraries(module))
    symbols = called_symbols(module)
    allowed = ALLOWED_LIBRARIES | set(sys.argv[3:])
    violations = [f"a game links {t}" for t in targets if t not in ALLOWED_TARGETS]
    violations += [f"{module.name} needs {n}" for n in libraries
                   if n.split(".so")[0] + ".so" not in allowed]
    violations += [f"{module.name} calls {s}" for s in sorted(symbols & FORBIDDEN_SYMBOLS)]
    if not targets or not libraries or not symbols:
        violations.append("checked no target, library or symbol")
    for violation in violations:
        print(violation)
    print(f"{len(targets)} targets, {len(libraries)} libraries and {len(symbols)} symbols checked, "
          f"{len(violations)} violations")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
