#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""For bad input, the program prints one line that says what is wrong and leaves no partial file."""

import itertools
import os
import re
import unittest

from flinch_program import ProgramTest, make_library, run

BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  End Site
  {
    OFFSET 0 10 0
  }
}
MOTION
Frames: 2
Frame Time: 0.0333333
0 0 0 0 0 0
0 0 0 0 0 0
"""


class BadInput(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.cases = 0

    def setUp(self):
        super().setUp()
        self.library = self.folder / "good.flinchlib"
        self.store = self.folder / "good.flinchobs"
        self.selector = self.folder / "good.flinch"
        self.out = self.folder / "out"
        make_library(self.library)

    def make_store_and_selector(self):
        self.succeed("simulate", self.library, "--out", self.store, "-n", 12)
        self.succeed("train", self.store, "--out", self.selector)

    def file(self, name, content):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content)
        return path

    def contents(self):
        """Returns the start of each file in the folder: all of it, but for one of holes."""
        return {p: p.open("rb").read(1 << 24) for p in self.folder.iterdir() if p.is_file()}

    def refuse(self, code, expected, *arguments):
        """Expects that the command fails with this code and message and writes nothing."""
        before = self.contents()
        line = self.fail_with(code, *arguments)
        for words in [expected] if isinstance(expected, str) else expected:
            self.assertIn(words, line)
        after = self.contents()
        self.assertEqual(after, before, arguments)
        type(self).cases += 1

    def readers(self, path):
        """Returns each command that reads a file, with this file."""
        return {
            "library": ["simulate", path, "--out", self.out, "-n", 2],
            "store to train on": ["train", path, "--out", self.out],
            "store to compare on": ["compare", path],
            "store to export": ["export", path, "--out", f"{self.out}.csv"],
            "store to merge": ["merge", path, "--out", self.out],
            "selector": ["select", path],
            "anything": ["info", path],
        }

    def test_files_that_are_not_what_they_should_be(self):
        self.make_store_and_selector()
        folder = self.folder / "folder"
        folder.mkdir()
        strange = {
            "missing": (self.folder / "missing", "missing: "),
            "folder": (folder, "folder"),
            "empty": (self.file("empty", ""), "empty"),
            "text": (self.file("text", "Dear Sir,\n"), "text file"),
            "binary": (self.file("binary", bytes(range(256)) * 9), "no file that Flinch knows"),
        }
        for name, (path, words) in strange.items():
            for what, command in self.readers(path).items():
                with self.subTest(file=name, read_as=what):
                    self.refuse(1, [str(path), words], *command)

    def test_inputs_that_never_end(self):
        fifo = self.folder / "fifo"
        os.mkfifo(fifo)
        sparse = self.file("sparse.bvh", "HIERARCHY\n")
        with sparse.open("r+b") as file:
            file.truncate(1 << 42)  # of holes
        endless = {
            "fifo": (fifo, "is a pipe or a device"),
            "device": ("/dev/zero", "is a pipe or a device"),
        }
        for name, (path, words) in endless.items():
            commands = {**self.readers(path),
                        "BVH": ["import", path, "--out", self.out],
                        "manifest": ["import", self.folder, "--manifest", path, "--out", self.out],
                        "character": ["author", "--character", path, "--out", self.out]}
            for what, command in commands.items():
                with self.subTest(file=name, read_as=what):
                    self.refuse(1, [str(path), words], *command)
        long = self.file("long.toml", "#" * (1 << 24) + "\n")
        for command in (["import", self.folder, "--manifest", long, "--out", self.out],
                        ["simulate", self.library, "--threats", long, "--out", self.out, "-n", 1],
                        ["evolve", self.library, "--pain", long, "--out", self.out]):
            with self.subTest(command=command[0]):
                self.refuse(1, [str(long), "larger than 16 MiB"], *command)
        long.unlink()
        sizes = {p: p.stat().st_size for p in self.folder.iterdir()}
        line = self.fail_with(1, "import", sparse, "--out", self.out)
        self.assertIn("larger than 1 GiB", line)
        self.assertEqual({p: p.stat().st_size for p in self.folder.iterdir()}, sizes)

    def test_one_kind_of_file_for_another(self):
        self.make_store_and_selector()
        kinds = {"library": self.library, "store": self.store, "selector": self.selector,
                 "BVH": self.file("a.bvh", BVH)}
        for given, path in kinds.items():
            for what, command in self.readers(path).items():
                if what == "anything" or what.startswith(given):
                    continue
                with self.subTest(given=given, read_as=what):
                    self.refuse(1, [str(path), given], *command)

    def test_truncated_and_damaged_files(self):
        self.make_store_and_selector()
        for kind, path in [("library", self.library), ("store", self.store),
                           ("selector", self.selector)]:
            whole = path.read_bytes()
            commands = [c for what, c in self.readers(path).items() if what.startswith(kind)]
            for size in (17, len(whole) // 2, len(whole) - 1):
                path.write_bytes(whole[:size])
                for command in commands + [["info", path]]:
                    with self.subTest(kind=kind, bytes=size, command=command[0]):
                        self.refuse(1, str(path), *command)
            if kind != "store":
                path.write_bytes(whole[:-40] + bytes(40))
                self.refuse(1, str(path), *commands[0])
            path.write_bytes(whole)

    def test_unknown_joint_names_come_with_roles_to_correct_and_give(self):
        self.make_store_and_selector()
        bvh = self.folder / "out.bvh"
        self.succeed("respond", self.selector, "--out", bvh)
        numbers = itertools.count()
        bvh.write_text(re.sub(r"(ROOT|JOINT) \S+", lambda word: f"{word[1]} bone{next(numbers)}",
                              bvh.read_text()))
        done = run("info", bvh)
        self.assertEqual(done.returncode, 1, done.stderr)
        line, _, table = done.stderr.partition("\n")
        self.assertTrue(line.startswith(f"flinch: {bvh}: no joint found for "), line)
        self.succeed("info", bvh, "--roles", self.file("roles.toml", table))

        files = self.folder / "takes"
        files.mkdir()
        for name in ("one.bvh", "two.bvh"):
            (files / name).write_text(bvh.read_text())
        (files / "half.bvh").write_text(bvh.read_text()[:200])
        done = run("import", files, "--out", self.folder / "none.flinchlib")
        self.assertEqual(done.returncode, 1, done.stderr)
        for name in ("half.bvh", "one.bvh", "two.bvh"):
            self.assertIn(f"skipped {files / name}:", done.stderr)
        line = f"flinch: {files}: none of its 3 motion files can be used; these roles are suggested"
        self.assertIn(f"{line} for {files / 'one.bvh'}\n{table}", done.stderr)
        type(self).cases += 2

    def test_bvh_and_manifests(self):
        frames = BVH.splitlines(keepends=True)
        cases = {
            "short.bvh": ("".join(frames[:-1]) + "0 0 0\n", ":"),
            "counts.bvh": (BVH.replace("CHANNELS 6", "CHANNELS 9"), ":"),
            "nan.bvh": (BVH.replace("0 0 0 0 0 0\n", "0 0 nan 0 0 0\n", 1), ":14"),
            "figure.bvh": (BVH, "figure.bvh"),
        }
        for name, (text, words) in cases.items():
            path = self.file(name, text)
            with self.subTest(file=name):
                self.refuse(1, [str(path), words], "import", path, "--out", self.out)
        bvh = self.file("a.bvh", BVH)
        idle = '[[idle]]\nname = "i"\nfile = "a.bvh"\n'
        clip = (idle + '[[clip]]\nname = "a"\nfile = "a.bvh"\ndirection = 0\n'
                'degree = "mild"\nonset = 0.0\npeak = 0.02\n')
        manifests = {
            "syntax": ("[[clip]\n", ":1"),
            "target": (clip + 'target = "nose"\n', ["head", "trunk", "pelvis", "legs"]),
            "file": (idle.replace("a.bvh", "none.bvh"), ["file.toml:", "none.bvh"]),
        }
        for name, (text, words) in manifests.items():
            path = self.file(f"{name}.toml", text)
            with self.subTest(manifest=name):
                self.refuse(1, words, "import", bvh, "--manifest", path, "--out", self.out)

    def test_text_in_utf16(self):
        self.make_store_and_selector()
        for coding in ("utf-16", "utf-16-le", "utf-16-be"):
            words = "is text in UTF-16"
            bvh = self.file("a.bvh", BVH.encode(coding))
            toml = self.file("a.toml", '[[idle]]\nname = "i"\nfile = "a.bvh"\n'.encode(coding))
            for path, command in (
                    (bvh, ["info", bvh]), (bvh, ["import", bvh, "--out", self.out]),
                    (toml, ["import", bvh, "--manifest", toml, "--out", self.out]),
                    (toml, ["import", bvh, "--roles", toml, "--out", self.out]),
                    (toml, ["author", "--character", toml, "--out", self.out]),
                    (toml, ["evolve", self.library, "--pain", toml, "--out", self.out]),
                    (toml, ["simulate", self.library, "-n", 1, "--threats", toml,
                            "--out", self.out]),
                    (toml, ["compare", self.store, "--vulnerability", toml])):
                with self.subTest(coding=coding, command=command):
                    self.refuse(1, f"{path}: {words}", *command)

    def test_wrong_usage(self):
        self.make_store_and_selector()
        for words, command in [
                ("flinch --help", []),
                ("flinch --help", ["dance"]),
                ("flinch select --help", ["select"]),
                ("--speeed", ["select", self.selector, "--speeed", 3]),
                (["head", "trunk", "pelvis", "legs"], ["select", self.selector, "--target", "nose"]),
                ("--speed", ["select", self.selector, "--speed", "fast"]),
                ("--speed", ["select", self.selector, "--speed", "nan"]),
                ("--time-to-impact", ["select", self.selector, "--time-to-impact", -1]),
                ("--brawn", ["train", self.store, "--out", self.out, "--brawn", 2]),
                (["svm", "knn"], ["train", self.store, "--out", self.out, "--model", "oracle"]),
                (["--vulnerability", "blunt", "FILE.toml"],
                 ["compare", self.store, "--vulnerability", "none"]),
                ("--out", ["simulate", self.library, "-n", 2]),
                ("-n", ["simulate", self.library, "--out", self.out, "-n", 0]),
                ("--out", ["merge", self.store]),
                ("STORE", ["merge", "--out", self.out]),
                ("--threads", ["simulate", self.library, "--out", self.out, "-n", 2, "--threads", 0]),
                ("--threads", ["train", self.store, "--out", self.out, "--threads", 0]),
                ("knn twice", ["compare", self.store, "--models", "knn,svm,knn"]),
                ("knn twice", ["compare", self.store, "--models", "knn", "knn"]),
                *(([option, "not in range"], [command, self.selector, *out, option, value])
                  for command, out in (("select", ()), ("respond", ("--out", f"{self.out}.bvh")))
                  for option, value in (("--mass", 1e-4), ("--mass", 1001), ("--radius", 1e-4),
                                        ("--radius", 11), ("--speed", 0.01), ("--speed", 1000),
                                        ("--time-to-impact", 11), ("--elevation", 90),
                                        ("--azimuth", 400))),
        ]:
            with self.subTest(command=command):
                self.refuse(2, words, *command)

    def test_vulnerability_tables(self):
        self.make_store_and_selector()
        tables = {
            "syntax": ("name = \n", ":1"),
            "body": ('name = "a"\n[bodies]\nnose = 1\n', [":3", '"nose"', "head", "hand"]),
            "range": ('name = "a"\n[bodies]\nhead = 2\n', [":3", "from 0 to 1"]),
            "missing": ('name = "a"\n[bodies]\nhead = 1\n', [":2", "no value for"]),
        }
        for name, (text, words) in tables.items():
            path = self.file(f"{name}.toml", text)
            for command in (["train", self.store, "--out", self.out], ["compare", self.store],
                            ["export", self.store, "--out", f"{self.out}.csv"]):
                with self.subTest(table=name, command=command[0]):
                    self.refuse(1, [str(path), *([words] if isinstance(words, str) else words)],
                                *command, "--vulnerability", path)
        table = self.file("table.toml", 'name = "a"\n')
        self.refuse(1, "is an input", "train", self.store, "--out", table, "--vulnerability", table)

    def test_places_that_cannot_be_written(self):
        self.make_store_and_selector()
        nowhere = self.folder / "no" / "where"
        for command in [["simulate", self.library, "--out", nowhere, "-n", 2],
                        ["train", self.store, "--out", nowhere],
                        ["merge", self.store, "--out", nowhere],
                        ["export", self.store, "--out", f"{nowhere}.csv"],
                        ["compare", self.store, "--report", self.library / "report"],
                        ["simulate", self.library, "--out", self.folder, "-n", 2],
                        ["merge", self.store, "--out", self.folder],
                        ["train", self.store, "--out", self.folder]]:
            with self.subTest(command=command):
                self.refuse(1, str(command[-1] if command[-2] != "-n" else command[-3]), *command)
        self.refuse(1, "is a selector; give --force", "simulate", self.library, "--out", self.selector, "-n", 2)
        self.refuse(1, ".libsvm or .csv", "export", self.store, "--out", self.folder / "a.xls")

    def test_too_few_scenarios(self):
        self.succeed("simulate", self.library, "--out", self.store, "-n", 1)
        self.refuse(1, "at least 2", "train", self.store, "--out", self.out)
        self.refuse(1, [str(self.store), "holds scenarios 0 to 0, 1 in all", "--first 5"],
                    "simulate", self.library, "--out", self.store, "-n", 5, "--first", 5)
        self.refuse(1, "at least 8", "compare", self.store)

    def test_every_threat_in_the_ranges_has_a_response(self):
        self.make_store_and_selector()
        balls = ((0.001, 0.1), (0.001, 900), (10, 900))  # a large one that is slow comes from below
        for mass, (radius, speed) in itertools.product((0.001, 1000), balls):
            with self.subTest(mass=mass, radius=radius, speed=speed):
                self.succeed("respond", self.selector, "--out", f"{self.out}.bvh", "--mass", mass,
                             "--radius", radius, "--speed", speed, "--time-to-impact", 0.01)

    def test_threats_from_below_the_ground(self):
        self.make_store_and_selector()
        self.refuse(1, "below the ground", "select", self.selector, "--speed", 5,
                    "--time-to-impact", 3)
        self.refuse(1, "raise --elevation to at least", "select", self.selector, "--speed", 20,
                    "--time-to-impact", 1, "--elevation", 0)

    @classmethod
    def tearDownClass(cls):
        if cls.cases == 0:
            raise AssertionError("no case was checked")
        super().tearDownClass()


if __name__ == "__main__":
    unittest.main()
