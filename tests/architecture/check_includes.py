#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails when a file includes what the order of the rooms forbids.

Usage: check_includes.py ROOT TARGETS

ROOT is the folder that holds the rooms. TARGETS names a file of lines `KIND TARGET SOURCE`, KIND
being `runtime` or `offline`, one for each source (a path under ROOT) of each library and program.
A header goes with the source of the same name; one that has none is run-time code unless its room
has no such code or offline code alone includes it.
"""

import re
import sys
from pathlib import Path

# Each room with those that it may include.
ROOMS = {
    "motion": [],
    "database": ["motion"],
    "features": ["motion"],
    "models": ["motion", "features"],
    "runtime": ["motion", "features", "models", "database"],
    "sim": ["motion", "features", "models", "database", "runtime"],
    "train": ["motion", "database", "features", "models", "runtime", "sim"],
}
OFFLINE_ROOMS = {"sim", "train"}
# Third-party headers that all code of a room may include, then those that only its offline code
# may. A name that ends in a slash stands for the folder.
HEADERS = {
    "motion": ["Eigen/"],
    "database": ["Eigen/", "flatbuffers/"],
    "features": ["Eigen/"],
    "models": ["Eigen/"],
    "runtime": ["Eigen/", "flatbuffers/", "stddef.h", "stdint.h"],  # these for the C interface
    "sim": ["Eigen/"],
    "train": ["Eigen/", "flatbuffers/"],
}
OFFLINE_HEADERS = {
    "database": ["toml++/", "nlohmann/", "lbfgs.h"],
    "models": ["libsvm/", "flann/"],
    "sim": ["ode/"],
    "train": ["sqlite3.h", "omp.h", "mpi.h", "CLI/", "spdlog/", "nlohmann/"],
}
# The operating system's headers, for files, terminals and signals: offline code alone.
SYSTEM_HEADERS = ["fcntl.h", "signal.h", "unistd.h", "sys/"]
# The run time starts no thread, asks no clock, draws no chance and prints nothing.
NOT_AT_RUN_TIME = {"barrier", "chrono", "condition_variable", "csignal", "ctime", "future",
                   "iostream", "latch", "mutex", "random", "semaphore", "shared_mutex", "thread"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
STANDARD_HEADER = re.compile(r"[a-z_]+")  # <vector>, <cmath>: no dot, no slash


def includes_of(text: str):
    """(line, the project's header or None, the foreign header or None) of each include."""
    for match in INCLUDE.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, match.group(1), match.group(2)


class Checker:
    def __init__(self, root: Path, targets: Path):
        self.root = root
        self.files = {}
        for room in ROOMS:
            for file in sorted((root / room).glob("**/*")):
                if file.suffix in (".h", ".cpp"):
                    self.files[file.relative_to(root).as_posix()] = list(
                        includes_of(file.read_text(encoding="utf-8")))
        self.kind = {}
        for line in targets.read_text(encoding="utf-8").splitlines():
            kind, _, source = line.split()
            self.kind[source] = kind
            self.kind.setdefault(source.removesuffix(".cpp") + ".h", kind)
        self.find_kinds_of_lone_headers()

    def find_kinds_of_lone_headers(self):
        by_runtime = self.reached_from("runtime")
        by_offline = self.reached_from("offline")
        for path in self.files:
            if path.endswith(".h") and path not in self.kind:
                alone = path in by_offline and path not in by_runtime
                offline = alone or path.split("/")[0] in OFFLINE_ROOMS
                self.kind[path] = "offline" if offline else "runtime"

    def reached_from(self, kind: str):
        """The headers without a source that files of this kind include, through such headers."""
        reached = set()
        waiting = [path for path in self.files if self.kind.get(path) == kind]
        while waiting:
            for _, own, _ in self.files[waiting.pop()]:
                if own in self.files and own not in self.kind and own not in reached:
                    reached.add(own)
                    waiting.append(own)
        return reached

    def violations(self):
        for path, includes in self.files.items():
            if path not in self.kind:
                yield f"{path}:1: no target compiles it"
                continue
            for line, own, foreign in includes:
                wrong = self.own_include(path, own) if own else self.foreign_include(path, foreign)
                if wrong:
                    yield f"{path}:{line}: {wrong}"
        if not self.files:
            yield f"{self.root}: checked no file"

    def own_include(self, path: str, included: str):
        room = path.split("/")[0]
        rooms = [room, *ROOMS[room]]
        if included.endswith("_generated.h"):
            schema = included.removesuffix("_generated.h") + ".fbs"
            if any((self.root / other / schema).exists() for other in rooms):
                return None
            return f'"{included}" is made from no schema that {room}/ may know'
        if included not in self.files:
            return f'"{included}" is no header of a room: include by ROOM/FILE'
        other = included.split("/")[0]
        if other not in rooms:
            return f'{room}/ may not include {other}/ ("{included}")'
        if self.kind[path] == "runtime" and self.kind.get(included) == "offline":
            return f'run-time code may not include offline code ("{included}")'
        return None

    def foreign_include(self, path: str, included: str):
        room = path.split("/")[0]
        runtime = self.kind[path] == "runtime"
        if STANDARD_HEADER.fullmatch(included):
            if runtime and included in NOT_AT_RUN_TIME:
                return f"run-time code may not include <{included}>"
            return None
        allowed = HEADERS[room]
        if not runtime:
            allowed = allowed + OFFLINE_HEADERS.get(room, []) + SYSTEM_HEADERS
        if any(included == name or (name.endswith("/") and included.startswith(name))
               for name in allowed):
            return None
        side = self.kind[path].replace("runtime", "run-time")
        return f"{side} code of {room}/ may not include <{included}>"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    checker = Checker(Path(sys.argv[1]), Path(sys.argv[2]))
    violations = list(checker.violations())
    for violation in violations:
        print(violation)
    print(f"{len(checker.files)} files checked, {len(violations)} violations")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
