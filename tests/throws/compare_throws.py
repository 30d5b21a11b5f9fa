#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare_throws.py [--library LIBRARY] SELECTOR NATIVE COMMAND...: fails unless COMMAND SELECTOR [LIBRARY],
such as a program of another system, gives what the program NATIVE gives: the same clips, and poses within
1e-5."""

import subprocess
import sys

MAX_DIFFERENCE = 1e-5


def lines_of(command, files):
    done = subprocess.run([*command, *files], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{command[-1]}: exit code {done.returncode}: {done.stderr}")
    return done.stdout.splitlines()


def main():
    library = [sys.argv[2]] if sys.argv[1] == "--library" else []
    selector, native, *command = sys.argv[1 + 2 * len(library):]
    files = [selector, *library]
    expected, seen = lines_of([native], files), lines_of(command, files)
    if len(expected) != len(seen):
        sys.exit(f"{len(seen)} lines instead of {len(expected)}")
    clips, poses, largest = set(), 0, 0.0
    for number, (one, other) in enumerate(zip(expected, seen), 1):
        if not one.startswith("pose"):
            if one != other:
                sys.exit(f"line {number}: {other!r} instead of {one!r}")
            clips.add(one.split()[-1])
            continue
        poses += 1
        numbers = [[float(word) for word in line.split()[1:]] for line in (one, other)]
        largest = max([largest, *(abs(a - b) for a, b in zip(*numbers, strict=True))])
    if not largest <= MAX_DIFFERENCE:
        sys.exit(f"poses differ by {largest:.2g}, which is more than {MAX_DIFFERENCE:g}")
    if len(clips) < 10 or poses < 600:
        sys.exit(f"only {len(clips)} clips and {poses} poses were compared")
    print(f"{len(clips)} clips, the same; {poses} poses within {largest:.1g}")


if __name__ == "__main__":
    main()
