#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures whole runs of `flinch simulate`, and prints the tables of docs/scale.md.

Usage: scale_study.py PROGRAM LIBRARY [LARGEST]

Runs 1,000, 8,200, 30,000 and 100,000 scenarios, up to LARGEST, then the same work on one and two
threads, one and two processes, and with little memory. CPU time and memory are what the system says
of the whole process.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

COMPARED = 8200  # scenarios of the runs that are compared with each other


def measure(*command):
    """Wall and CPU seconds, and peak memory of the largest process in MiB, of a command."""
    begin = time.monotonic()
    process = subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(errors.decode())
    return time.monotonic() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


class Study:
    def __init__(self, program, library, folder):
        self.program = program
        self.library = library
        self.folder = folder

    def run(self, scenarios, *options, launcher=()):
        store = Path(self.folder) / "store"
        store.unlink(missing_ok=True)
        result = measure(*launcher, self.program, "simulate", self.library, "--out", store, "-n",
                         scenarios, *options)
        return (*result, store.stat().st_size / scenarios)

    def print_curve(self, largest):
        print("| scenarios | CPU s | CPU ms a scenario | wall s | peak MiB | bytes a scenario |")
        print("| --: | --: | --: | --: | --: | --: |")
        for scenarios in (1000, 8200, 30_000, 100_000):
            if scenarios > largest:
                break
            wall, cpu, peak, size = self.run(scenarios, "--threads", os.cpu_count())
            print(f"| {scenarios:,} | {cpu:.1f} | {1000 * cpu / scenarios:.2f} | {wall:.1f} | "
                  f"{peak:.0f} | {size:,.0f} |", flush=True)

    def print_ways(self):
        print(f"\n| {COMPARED:,} scenarios | wall s | times as fast | CPU s | peak MiB |")
        print("| :-- | --: | --: | --: | --: |")
        mpirun = [shutil.which("mpirun"), "--allow-run-as-root", "--oversubscribe", "-n"]
        ways = [("one thread", ["--threads", 1], []),
                ("two threads", ["--threads", 2], []),
                ("one thread, 128 MiB", ["--threads", 1, "--memory", "128M"], [])]
        if mpirun[0]:
            ways.insert(2, ("two MPI processes", ["--threads", 1], [*mpirun, 2]))
        alone = None
        for name, options, launcher in ways:
            wall, cpu, peak, _ = self.run(COMPARED, *options, launcher=launcher)
            alone = alone or wall
            print(f"| {name} | {wall:.1f} | {alone / wall:.2f} | {cpu:.1f} | {peak:.0f} |",
                  flush=True)


def main():
    if len(sys.argv) not in (3, 4) or sys.argv[1] in ("--help", "-h"):
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv or "-h" in sys.argv else 2)
    with tempfile.TemporaryDirectory() as folder:
        study = Study(sys.argv[1], sys.argv[2], folder)
        study.print_curve(int(sys.argv[3]) if len(sys.argv) > 3 else 100_000)
        study.print_ways()


if __name__ == "__main__":
    main()
