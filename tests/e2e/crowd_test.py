#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Twenty characters that push each other (examples/crowd)."""

import json
import os
import pathlib
import re
import struct
import subprocess
import unittest

from flinch_program import ProgramTest, make_library, shared_folder


def crowd(*arguments):
    return subprocess.run([os.environ["FLINCH_CROWD"], *map(str, arguments)], capture_output=True,
                          text=True, check=False)


def selector():
    """A selector with pushes, everyday motion and a realism model."""
    folder = shared_folder()
    made = folder / "a.flinch"
    if not made.exists():
        maker = ProgramTest("document")
        make_library(folder / "a.flinchlib", "walks")
        maker.succeed("simulate", folder / "a.flinchlib", "--out", folder / "a.flinchobs", "-n", 12)
        maker.succeed("train", folder / "a.flinchobs", "--out", made, "--model", "knn")
        maker.succeed("label", folder / "a.flinchlib", "--out", folder / "a.flinchlabels",
                      "--proxy", 150)
        maker.succeed("train-realism", folder / "a.flinchlabels", "--into", made)
    return made


class Crowd(ProgramTest):
    def test_a_minute_has_the_same_bits_twice_and_only_finite_numbers(self):
        first, again = crowd(selector()), crowd(selector())
        self.assertEqual(first.returncode, 0, first.stdout + first.stderr)
        # All but the time that it took.
        hash_of = re.compile(r"hash (\w{16})")
        self.assertEqual(hash_of.findall(first.stdout), hash_of.findall(again.stdout))
        self.assertEqual(first.stdout.splitlines()[:2], again.stdout.splitlines()[:2])
        self.assertIn("every number is finite", first.stdout)
        self.assertIn("20 characters for 60 s", first.stdout)
        bumps, walls = map(int, re.search(r"(\d+) bumps, (\d+) touches", first.stdout).groups())
        self.assertGreater(bumps, 20)
        self.assertGreater(walls, 0)
        answered, physical = (int(re.search(rf"(\d+) {word}", first.stdout)[1])
                              for word in ("pushes answered", "by physics"))
        self.assertGreater(answered, 20)
        self.assertGreater(physical, 0)  # a library of six responses does not answer all
        outside_m = float(re.search(r"at most (\S+) m outside", first.stdout)[1])
        self.assertLess(outside_m, 0.6)

    def test_the_animation_moves_twenty_figures(self):
        out = self.folder / "crowd.glb"
        self.assertEqual(crowd(selector(), out, 3).returncode, 0)
        content = out.read_bytes()
        length = struct.unpack_from("<I", content, 12)[0]
        document = json.loads(content[20:20 + length])
        self.assertEqual(len(document["skins"]), 20)
        self.assertEqual(len(document["meshes"]), 1)
        names = [node["name"] for node in document["nodes"]]
        self.assertEqual(len(set(names)), len(names))
        moved = {channel["target"]["node"] for channel in document["animations"][0]["channels"]}
        self.assertEqual(len(moved), 20 * 21)
        self.assertEqual(document["accessors"][document["animations"][0]["samplers"][0]["input"]]
                         ["count"], 180)

    def test_a_file_that_is_no_selector_is_refused(self):
        self.assertEqual(crowd(pathlib.Path(__file__)).returncode, 2)
        self.assertEqual(crowd().returncode, 2)


if __name__ == "__main__":
    unittest.main()
