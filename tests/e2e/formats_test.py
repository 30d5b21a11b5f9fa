#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files of every version of the formats so far, in tests/formats, are read or refused by name."""

import gzip
import pathlib
import shutil
import sqlite3
import unittest

from flinch_program import ProgramTest

FROZEN = pathlib.Path(__file__).resolve().parent.parent / "formats"
CHOSEN = {"selector-3-knn.flinch": "cover_mirrored", "selector-3-svm.flinch": "idle",
          "selector-3-pairwise_cost.flinch": "cover_mirrored"}
# Of each kind those that are refused, and those that are read; the last is today's.
REFUSED = {"library": (1,), "store": (1, 2), "selector": (1, 2)}
READ = {"library": (2, 3, 4), "store": (3, 4, 5, 6, 7), "selector": (3,)}


class Formats(ProgramTest):
    def setUp(self):
        super().setUp()
        for path in FROZEN.glob("*-*"):
            if path.suffix == ".gz":
                (self.folder / path.stem).write_bytes(gzip.decompress(path.read_bytes()))
            else:
                shutil.copy(path, self.folder)

    def files(self, kind, version):
        found = sorted(self.folder.glob(f"{kind}-{version}*"))
        self.assertTrue(found, f"{kind} {version}")
        return found

    def readers(self, kind, path):
        out = self.folder / "out"
        return {"library": [["simulate", path, "--out", out, "-n", 1],
                            ["author", "--character", path, "--out", out]],
                "store": [["train", path, "--out", out], ["compare", path],
                          ["merge", path, "--out", out]],
                "selector": [["select", path], ["respond", path, "--out", f"{out}.bvh"]]}[kind]

    def test_there_is_a_file_of_every_version(self):
        here = {tuple(path.name.split(".")[0].split("-")[:2]) for path in FROZEN.glob("*-*")}
        self.assertEqual(here, {(kind, str(version)) for kind in READ
                                for version in REFUSED[kind] + READ[kind]})
        self.assertLess(max(path.stat().st_size for path in FROZEN.iterdir()), 12000)

    def test_earlier_versions_are_refused_by_name(self):
        for kind, refused in REFUSED.items():
            today = READ[kind][-1]
            for version in refused:
                for path in self.files(kind, version):
                    for command in [["info", path], *self.readers(kind, path)]:
                        with self.subTest(file=path.name, command=command[0]):
                            line = self.fail_with(1, *command)
                            self.assertRegex(line, rf"{path}: .*of format {version}, "
                                                   rf"and this program reads format.* {today}")
        self.assertEqual(list(self.folder.glob("out*")), [])

    def test_a_library_with_a_stance_is_read(self):
        path, = self.files("library", 3)
        library = self.document("info", path)
        self.assertEqual((library["name"], library["hash"]), ("frozen", "83742410ba53068f"))
        self.assertEqual([(clip["name"], clip["purpose"]) for clip in library["clips"]],
                         [("idle", "idle"), ("cover", "anticipation"),
                          ("cover_mirrored", "anticipation"), ("guard", "stance")])
        self.succeed("simulate", path, "--out", self.folder / "new", "-n", 1)

    def test_a_library_of_packed_poses_is_read_and_written_again_to_the_same_bytes(self):
        path, = self.files("library", 4)
        library = self.document("info", path)
        self.assertEqual((library["name"], library["hash"]), ("frozen", "bfee1e0a82003cd8"))
        self.assertEqual([(clip["name"], clip["purpose"]) for clip in library["clips"]],
                         [("idle", "idle"), ("cover", "anticipation"),
                          ("cover_mirrored", "anticipation"), ("guard", "stance")])
        store = self.folder / "new"
        self.succeed("simulate", path, "--out", store, "-n", 1)
        with sqlite3.connect(store) as database:
            (copy,), = database.execute("SELECT file FROM library")
        self.assertEqual(copy, path.read_bytes())

    def test_libraries_without_stances_are_read(self):
        path, = self.files("library", 2)
        library = self.document("info", path)
        self.assertEqual((library["name"], library["rate_hz"], library["hash"]),
                         ("frozen", 10, "e101abd6b2137305"))
        self.assertEqual([clip["name"] for clip in library["clips"]],
                         ["idle", "cover", "cover_mirrored"])
        self.assertEqual(library["clips"][1]["annotation"]["direction_degrees"], 45)
        self.succeed("simulate", path, "--out", self.folder / "new", "-n", 1)

    def test_stores_are_read(self):
        for version in READ["store"]:
            path, = self.files("store", version)
            with self.subTest(path.name):
                store = self.document("info", path)
                self.assertEqual((store["scenarios"], store["seed"], store["trials"]), (4, 1, 6))
                self.succeed("train", path, "--out", self.folder / "new", "--model", "knn")

    def test_an_earlier_store_is_merged_into_one_of_today_and_not_continued(self):
        earlier, = self.files("store", 3)
        merged = self.folder / "merged"
        self.succeed("merge", earlier, "--out", merged)
        for path in (earlier, merged):
            self.succeed("export", path, "--out", f"{path}.csv")
        self.assertEqual((self.folder / "merged.csv").read_bytes(),
                         pathlib.Path(f"{earlier}.csv").read_bytes())
        with sqlite3.connect(merged) as database:
            self.assertEqual(database.execute("PRAGMA user_version").fetchone(), (6,))
        before = earlier.read_bytes()
        line = self.fail_with(1, "simulate", self.files("library", 2)[0], "--out", earlier, "-n", 8)
        self.assertIn("another scenario distribution", line)
        self.assertEqual(earlier.read_bytes(), before)

    def test_selectors_of_today_are_read_and_choose_as_ever(self):
        for path in self.files("selector", 3):
            with self.subTest(path.name):
                selector = self.document("info", path)
                self.assertEqual(selector["library_hash"], "e101abd6b2137305")
                self.assertEqual([kind["name"] for kind in selector["threats"]], ["volleyball"])
                chosen = self.document("select", path, "--azimuth", 40, "--target", "head")
                self.assertEqual(chosen["clip"], CHOSEN[path.name])


if __name__ == "__main__":
    unittest.main()
