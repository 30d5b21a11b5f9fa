#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Wherever a command fails or is killed while it writes, its output is the old file or the new one,
whole, and the next run gives the new one and leaves nothing else behind.

strace fails or kills each system call in turn that touches the folder of the output. A few calls of
each command, spread over all; with FLINCH_ALL_CRASH_POINTS=1 every call, with every fault.
"""

import hashlib
import os
import re
import shutil
import subprocess
import sys
import unittest

from flinch_program import FLINCH, ProgramTest, make_library, run, shared_folder

EVERY_POINT = os.environ.get("FLINCH_ALL_CRASH_POINTS") == "1"
POINTS_PER_COMMAND = 12  # of each of the two states before
CALLS = ("write", "writev", "pwrite64", "fsync", "fdatasync", "ftruncate", "fchmod", "rename",
         "renameat", "renameat2", "unlink", "unlinkat", "close")
FAULTS = ("error=ENOSPC", "error=EIO", "signal=SIGKILL")
ALONE = {**os.environ, "OMP_NUM_THREADS": "1"}  # the same calls in each run


def strace(*arguments, **options):
    return subprocess.run(["strace", "-f", "-qq", *map(str, arguments)],
                          capture_output=True, text=True, check=False, env=ALONE, **options)


def can_trace():
    return shutil.which("strace") and strace("-o", "/dev/null", "true").returncode == 0


def digests(content):
    return {name: hashlib.sha256(data).hexdigest() for name, data in content.items()}


def inputs():
    """A folder with the inputs of all commands, made once."""
    folder = shared_folder() / "inputs"
    if not folder.exists():
        folder.mkdir()
        make_library(folder / "a.flinchlib")
        for arguments in (["author", "--out", "b.flinchlib"],
                          ["simulate", "a.flinchlib", "--out", "a.flinchobs", "-n", 2],
                          ["simulate", "a.flinchlib", "--out", "b.flinchobs", "-n", 2, "--first", 2],
                          ["simulate", "a.flinchlib", "--out", "c.flinchobs", "-n", 12],
                          ["train", "c.flinchobs", "--out", "a.flinch", "--model", "knn"],
                          ["respond", "a.flinch", "--out", "a.bvh"],
                          ["respond", "a.flinch", "--azimuth", 90, "--out", "b.bvh"]):
            done = run(*arguments, cwd=folder)
            assert done.returncode == 0, done.stderr
    return folder


class Crash(ProgramTest):
    points = 0

    def setUp(self):
        super().setUp()
        self.inputs = inputs()
        self.out = self.folder / "out"
        self.out.mkdir()

    def content(self):
        return {path.name: path.read_bytes() for path in self.out.iterdir()}

    def begin(self, old):
        shutil.rmtree(self.out)
        self.out.mkdir()
        for name, data in old.items():
            (self.out / name).write_bytes(data)

    def calls(self, command):
        """Returns the calls that touch the folder of the output, each by its name and number."""
        log = self.folder / "log"
        done = strace("-y", "-e", "trace=" + ",".join(CALLS), "-o", log, FLINCH, *command,
                      cwd=self.inputs)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = log.read_text().splitlines()
        process = lines[0].split()[0]
        count, found = dict.fromkeys(CALLS, 0), []
        for line in lines:
            match = re.match(rf"{process} +(\w+)\(", line)
            if match:
                count[match[1]] += 1
                if str(self.out) in line:
                    found.append((match[1], count[match[1]]))
        return found

    def check(self, command, old, new, call, number, fault):
        self.begin(old)
        done = strace("-e", f"trace={call}", "-e", f"inject={call}:{fault}:when={number}",
                      "-o", "/dev/null", FLINCH, *command, cwd=self.inputs)
        where = f"{command[0]}: {fault} at {call} {number}: {done.returncode} {done.stderr}"
        after = self.content()
        for name in new:
            self.assertIn(after.get(name), (old.get(name), new[name]), f"{where}: {name}")
        if fault == "signal=SIGKILL":
            self.assertNotEqual(done.returncode, 0, where)
        elif done.returncode == 0:
            self.assertEqual(digests(after), digests(new), where)
        else:
            self.assertEqual(done.returncode, 1, where)
            self.assertRegex(done.stderr.splitlines()[-1], "^flinch: ", where)
        again = subprocess.run([FLINCH, *command], cwd=self.inputs, capture_output=True, text=True,
                               check=False)
        self.assertEqual(again.returncode, 0, f"{where}, then {again.stderr}")
        self.assertEqual(digests(self.content()), digests(new), f"{where}, then it was run again")
        type(self).points += 1

    def survive(self, name, earlier, command):
        """Crashes a command that writes the file `name`, where there is no such file and where
        `earlier`, another command, has made one."""
        self.survive_with(["--out", self.out / name], [name], earlier, command)

    def survive_with(self, output, names, earlier, command):
        """The same with all options that name outputs, and with the files that come of them."""
        command = [str(part) for part in (*command, *output)]
        for before in (None, earlier):
            self.begin({})
            if before:
                self.succeed(*before, *output, cwd=self.inputs)
            old = self.content()
            calls = self.calls(command)
            new = self.content()
            self.assertNotEqual(new, old)
            self.assertEqual(sorted(new), sorted(names))
            self.assertGreaterEqual(len(calls), 4, calls)
            points = [(*call, fault) for call in calls for fault in FAULTS]
            if not EVERY_POINT:
                step = len(points) / POINTS_PER_COMMAND
                points = [points[int((k + 0.5) * step)] for k in range(POINTS_PER_COMMAND)]
            for point in points:
                with self.subTest(command=command[0], point=point, old=bool(old)):
                    self.check(command, old, new, *point)

    def test_author(self):
        self.survive("x.flinchlib", ["author", "--startle"], ["author"])

    def test_import(self):
        self.survive("x.flinchlib", ["import", "b.bvh"], ["import", "a.bvh"])

    def test_simulate(self):
        simulate = ["simulate", "a.flinchlib", "--threads", 1, "-n"]
        self.survive("x.flinchobs", [*simulate, 1], [*simulate, 2])

    def test_merge(self):
        self.survive("x.flinchobs", ["merge", "a.flinchobs"], ["merge", "b.flinchobs", "a.flinchobs"])

    def test_train(self):
        train = ["train", "c.flinchobs", "--model"]
        self.survive("x.flinch", [*train, "knn_cost"], [*train, "knn"])

    def test_export(self):
        self.survive("x.csv", ["export", "b.flinchobs"], ["export", "a.flinchobs"])

    def test_respond(self):
        respond = ["respond", "a.flinch", "--azimuth"]
        for ending in ("glb", "svg") if EVERY_POINT else ("glb",):
            self.survive(f"x.{ending}", [*respond, 40], [*respond, 0])

    def test_export_of_clips(self):
        self.survive_with(["--clips", self.out], ["clips.glb"], ["export", "b.flinchlib"],
                          ["export", "a.flinchlib"])

    def test_evolve(self):
        evolve = ["evolve", "b.flinchlib", "--threads", 1, "--population", 4, "--tournament", 4,
                  "--generations", 2, "--seed"]
        self.survive("x.flinchlib", [*evolve, 2], [*evolve, 1])

    @classmethod
    def tearDownClass(cls):
        print(f"{cls.points} crashes survived", file=sys.stderr)
        if cls.points == 0:
            raise AssertionError("no crash was tried")
        super().tearDownClass()


if __name__ == "__main__":
    if not can_trace():
        print("skipped: strace is missing, or this system does not let it trace")
        sys.exit(77)
    unittest.main()
