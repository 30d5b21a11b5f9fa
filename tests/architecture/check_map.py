#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails if the code violates the map of docs/architecture.md.

Usage: check_map.py ROOT TARGETS

ROOT is the folder that holds the rooms. TARGETS names a file with lines of two kinds, made by
CMake: `source TARGET PATH` for each source file of a library or program (PATH under ROOT), and
`link TARGET OTHER` for each of the project's targets that it links.
"""

import re
import sys
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Folder:
    """A folder of the map: one library or program."""
    at_run_time: bool  # part of the run time, so a game links it
    may_use: list  # folders; a name that ends in a slash stands for all folders in it
    headers: list  # third-party headers; a name that ends in a slash stands for a folder of them


RUN_TIME = True
OFFLINE = False
SIM = ["motion", "features", "sim"]
ENCOUNTER = [*SIM, "sim/collision", "sim/figure", "sim/contact", "sim/tree", "sim/encounter"]
TRAIN = ["motion", "features", "database/library", "database/files", "models", "models/fit",
         "runtime", "runtime/response"]
# In order: a folder uses only folders above it, and of those only the ones that it names.
MAP = {
    "motion": Folder(RUN_TIME, [], ["Eigen/"]),
    "motion/skin": Folder(RUN_TIME, ["motion"], ["Eigen/"]),
    "features": Folder(RUN_TIME, ["motion"], ["Eigen/"]),
    "database/library": Folder(RUN_TIME, ["motion"], ["Eigen/", "flatbuffers/"]),
    "database/rules": Folder(RUN_TIME, ["motion", "features"], ["Eigen/"]),
    "database/quality": Folder(OFFLINE, ["motion", "database/library"], ["Eigen/"]),
    "database/files": Folder(OFFLINE, ["motion", "database/library"],
                             ["Eigen/", "flatbuffers/", "nlohmann/", "toml++/"]),
    "database/import": Folder(OFFLINE, ["motion", "database/library", "database/quality",
                                        "database/files"], ["Eigen/", "assimp/"]),
    "database/author": Folder(OFFLINE, ["motion", "features", "database/library",
                                        "database/rules", "database/files"], ["Eigen/", "lbfgs.h"]),
    "database/export": Folder(OFFLINE, ["motion", "motion/skin", "features", "database/library",
                                        "database/files"], ["Eigen/", "nlohmann/"]),
    "database/annotate": Folder(OFFLINE, ["motion", "database/library", "database/quality",
                                          "database/files", "database/import",
                                          "database/export"], ["Eigen/"]),
    "models": Folder(RUN_TIME, ["motion", "features"], ["Eigen/"]),
    "models/fit": Folder(OFFLINE, ["motion", "features", "models"],
                         ["Eigen/", "libsvm/", "flann/", "omp.h"]),
    "sim": Folder(RUN_TIME, ["motion", "features"], ["Eigen/"]),
    "sim/collision": Folder(RUN_TIME, SIM, ["Eigen/"]),
    "sim/figure": Folder(RUN_TIME, [*SIM, "sim/collision"], ["Eigen/"]),
    "sim/contact": Folder(RUN_TIME, [*SIM, "sim/collision", "sim/figure"], ["Eigen/"]),
    "sim/tree": Folder(RUN_TIME, [*SIM, "sim/collision", "sim/figure", "sim/contact"], ["Eigen/"]),
    "sim/encounter": Folder(RUN_TIME, ENCOUNTER[:-1], ["Eigen/"]),
    "sim/rehearsal": Folder(RUN_TIME, ENCOUNTER, ["Eigen/"]),
    "sim/ode": Folder(OFFLINE, ENCOUNTER,
                      ["Eigen/", "ode/", "mutex"]),  # ODE is initialised once per process
    "runtime/response": Folder(RUN_TIME, ["motion", "features", "database/library",
                                          "database/rules"], ["Eigen/"]),
    "runtime/push": Folder(RUN_TIME, ["motion", "database/library", "models", "runtime/response"],
                           ["Eigen/"]),
    "runtime/graph": Folder(RUN_TIME, ["motion", "features", "database/library",
                                       "runtime/response"], ["Eigen/"]),
    "runtime": Folder(RUN_TIME, ["motion", "features", "database/library", "models",
                                 "runtime/response", "runtime/push", "runtime/graph"],
                      ["Eigen/", "flatbuffers/"]),
    "reaction": Folder(RUN_TIME, [*ENCOUNTER, "runtime", "runtime/response"], ["Eigen/"]),
    "reaction/crowd": Folder(OFFLINE, ["motion", "database/library", "runtime", "reaction"],
                             ["Eigen/"]),
    "lookahead": Folder(RUN_TIME, [*ENCOUNTER, "models", "runtime", "runtime/response"],
                        ["Eigen/"]),
    "lookahead/oracle": Folder(RUN_TIME, [*ENCOUNTER, "sim/rehearsal", "database/library", "models",
                                          "runtime", "runtime/response"], ["Eigen/"]),
    "runtime/c": Folder(RUN_TIME, [*ENCOUNTER, "database/library", "models", "runtime",
                                   "runtime/graph", "runtime/response", "runtime/push", "reaction",
                                   "lookahead"],
                        ["Eigen/", "stddef.h", "stdint.h"]),
    "train/scenario": Folder(OFFLINE, ["motion", "features", "database/library",
                                       "database/files"], ["Eigen/", "toml++/"]),
    "train/realism": Folder(OFFLINE, ["motion", "features", "database/library", "database/files",
                                      "database/quality", "models", "runtime/response",
                                      "runtime/push"], ["Eigen/", "nlohmann/"]),
    "bindings/js": Folder(OFFLINE, [*ENCOUNTER, "motion/skin", "sim/rehearsal", "database/library",
                                    "models", "runtime", "runtime/response", "reaction",
                                    "reaction/crowd", "lookahead", "lookahead/oracle", "runtime/c",
                                    "runtime/push", "train/scenario", "train/realism"],
                          ["Eigen/"]),
    "train/objective": Folder(OFFLINE, ["motion", "features", "database/library",
                                        "database/files"], ["Eigen/", "toml++/"]),
    "train/store": Folder(OFFLINE, [*TRAIN, "train/scenario", "train/objective"],
                          ["Eigen/", "sqlite3.h"]),
    "train/simulate": Folder(OFFLINE, [*TRAIN, "sim", "sim/", "lookahead/oracle", "train/scenario",
                                       "train/objective", "train/store"],
                             ["Eigen/", "omp.h", "mpi.h", "nlohmann/"]),
    "train/fit": Folder(OFFLINE, [*TRAIN, "train/scenario", "train/objective", "train/store"],
                        ["Eigen/", "flatbuffers/"]),
    "train/evaluate": Folder(OFFLINE, [*TRAIN, "lookahead", "lookahead/oracle", "train/scenario",
                                       "train/objective", "train/store", "train/fit"], ["Eigen/"]),
    "train/report": Folder(OFFLINE, [*TRAIN, "train/scenario", "train/objective", "train/store",
                                     "train/fit", "train/evaluate"], ["Eigen/", "nlohmann/"]),
    "evolve/genetic": Folder(OFFLINE, ["motion", "features"], []),
    "evolve/pain": Folder(OFFLINE, ["motion", "sim", "database/files", "database/export"],
                          ["Eigen/"]),
    "evolve/label": Folder(OFFLINE, ["motion", "features", "sim", "database/library", "models",
                                     "train/scenario", "train/objective", "train/store",
                                     "evolve/pain"], ["Eigen/"]),
    "evolve/trial": Folder(OFFLINE, [*ENCOUNTER, "sim/rehearsal", "sim/ode", "database/library",
                                     "database/author", "database/quality", "evolve/genetic",
                                     "evolve/pain"], ["Eigen/", "omp.h"]),
    "evolve/run": Folder(OFFLINE, [*ENCOUNTER, "sim/rehearsal", "database/library",
                                   "database/files", "database/author", "database/quality",
                                   "evolve/genetic", "evolve/pain", "evolve/trial"],
                         ["Eigen/", "nlohmann/"]),
    "evolve/weakest": Folder(OFFLINE, [*TRAIN, "database/quality", "sim", "sim/", "train/scenario",
                                       "train/objective", "train/store", "train/simulate",
                                       "train/fit", "train/evaluate", "evolve/genetic",
                                       "evolve/trial", "evolve/run"], ["Eigen/", "omp.h"]),
    "bindings/python": Folder(OFFLINE, ["motion", "features", "database/", "models", "runtime",
                                        "runtime/c", "train/"],
                              ["Eigen/", "nlohmann/", "omp.h", "pybind11/"]),
    "program": Folder(OFFLINE, ["motion", "features", "database/", "models", "models/fit", "sim",
                                "sim/", "runtime", "runtime/response", "runtime/push", "reaction",
                                "lookahead", "train/", "evolve/"],
                      ["Eigen/", "CLI/", "nlohmann/", "omp.h", "spdlog/"]),
}
ROOMS = sorted({folder.split("/")[0] for folder in MAP})

# Headers that cost the compiler seconds per inclusion: only one file includes them.
ONLY_IN = {"CLI/": "program/command_line.cpp", "spdlog/": "program/log.cpp",
           "assimp/": "database/import/scene.cpp"}
# The operating system's headers, for files, terminals and signals: offline code only.
SYSTEM_HEADERS = ["fcntl.h", "sched.h", "signal.h", "unistd.h", "sys/"]
# The run time starts no thread, reads no clock, draws no random numbers and prints nothing.
NOT_AT_RUN_TIME = {"barrier", "chrono", "condition_variable", "csignal", "ctime", "future",
                   "iostream", "latch", "mutex", "random", "semaphore", "shared_mutex", "thread"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
STANDARD_HEADER = re.compile(r"[a-z_]+")  # <vector>, <cmath>: no dot, no slash


def matches(name: str, patterns):
    return any(name == p or (p.endswith("/") and name.startswith(p)) for p in patterns)


def folder_of(path: str):
    return path.rpartition("/")[0]


def is_usable(folder: str, other: str):
    return folder == other or matches(other, MAP[folder].may_use)


class Checker:
    def __init__(self, root: Path, targets: Path):
        self.root = root
        self.texts = {file.relative_to(root).as_posix(): file.read_text(encoding="utf-8")
                      for room in ROOMS for file in sorted((root / room).glob("**/*"))
                      if file.suffix in (".h", ".cpp")}
        self.target_of, self.links = {}, []
        for line in targets.read_text(encoding="utf-8").splitlines():
            kind, target, other = line.split()
            if kind == "source":
                self.target_of[other] = target
            else:
                self.links.append((target, other))

    def violations(self):
        if not self.texts:
            yield f"{self.root}: checked no file"
            return
        yield from self.target_violations()
        for path, text in self.texts.items():
            folder = folder_of(path)
            if folder not in MAP:
                yield f"{path}:1: {folder}/ is not on the map"
                continue
            if path.endswith(".cpp") and path not in self.target_of:
                yield f"{path}:1: no target compiles it"
            for match in INCLUDE.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                own, foreign = match.groups()
                wrong = (self.own_include(folder, own) if own else
                         self.foreign_include(path, foreign))
                if wrong:
                    yield f"{path}:{line}: {wrong}"
        for folder in MAP:
            if not any(folder_of(path) == folder for path in self.texts):
                yield f"{folder}/: on the map, but it holds no file"

    def target_violations(self):
        folders, targets = {}, {}
        for path, target in sorted(self.target_of.items()):
            folders.setdefault(target, set()).add(folder_of(path))
            targets.setdefault(folder_of(path), set()).add(target)
        for target, spanned in folders.items():
            if len(spanned) > 1:
                yield f"{target} spans {len(spanned)} folders: {', '.join(sorted(spanned))}"
        for folder, held in targets.items():
            if len(held) > 1:
                yield f"{folder}/ holds {len(held)} targets: {', '.join(sorted(held))}"
        for target, other in self.links:
            for folder in folders.get(target, ()):
                for used in folders.get(other, ()):
                    if folder in MAP and not is_usable(folder, used):
                        yield f"{target} may not link {other}: {folder}/ may not use {used}/"

    def own_include(self, folder: str, included: str):
        if included.endswith("_generated.h"):
            schema = included.removesuffix("_generated.h") + ".fbs"
            makers = [f for f in MAP if (self.root / f / schema).exists()]
            if any(is_usable(folder, maker) for maker in makers):
                return None
            return f'"{included}" is made from no schema that {folder}/ may use'
        if included.endswith("_embedded.h"):
            if (self.root / folder / included.removesuffix("_embedded.h")).is_dir():
                return None
            return f'"{included}" is made from no folder of {folder}/'
        if included not in self.texts:
            return f'"{included}" is no header of a room: include by ROOM/FILE'
        other = folder_of(included)
        if not is_usable(folder, other):
            return f'{folder}/ may not use {other}/ ("{included}")'
        return None

    def foreign_include(self, path: str, included: str):
        for header, file in ONLY_IN.items():
            if matches(included, [header]) and path != file:
                return f"only {file} may include <{included}>"
        folder = folder_of(path)
        at_run_time = MAP[folder].at_run_time
        if STANDARD_HEADER.fullmatch(included):
            if at_run_time and included in NOT_AT_RUN_TIME - set(MAP[folder].headers):
                return f"run-time code may not include <{included}>"
            return None
        allowed = MAP[folder].headers + ([] if at_run_time else SYSTEM_HEADERS)
        return None if matches(included, allowed) else f"{folder}/ may not include <{included}>"


def check_order():
    """The map itself: a folder names only folders above it, and run-time code no offline code."""
    above = []
    for name, folder in MAP.items():
        for other in folder.may_use:
            known = [f for f in above if matches(f, [other])]
            if not known:
                yield f"the map: {name}/ names {other}, which is not above it"
            if folder.at_run_time and any(not MAP[f].at_run_time for f in known):
                yield f"the map: {name}/, which games link, uses offline code of {other}"
        above.append(name)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    checker = Checker(Path(sys.argv[1]), Path(sys.argv[2]))
    violations = [*check_order(), *checker.violations()]
    for violation in violations:
        print(violation)
    print(f"{len(checker.texts)} files checked, {len(violations)} violations")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
