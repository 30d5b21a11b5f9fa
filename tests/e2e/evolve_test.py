#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pain by place, and poses that evolve."""

import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest
import unittest.mock

import takes
from flinch_program import FLINCH, ProgramTest, make_library, shared_folder

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


class Pain(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "default.flinchlib"

    def test_the_drawing_in_the_docs_is_of_the_default_library(self):
        self.succeed("author", "--out", self.library)
        drawn = self.folder / "pain.svg"
        self.succeed("info", self.library, "--pain", drawn)
        self.assertEqual(drawn.read_text(), (DOCS / "pain.svg").read_text())
        self.succeed("info", self.library, "--pain", drawn)  # its own file

    def test_refuses_to_draw_over_other_files_or_what_is_no_library(self):
        make_library(self.library)
        note = self.folder / "note.svg"
        note.write_text("<svg>mine</svg>\n")
        self.assertIn("--force", self.fail_with(1, "info", self.library, "--pain", note))
        self.assertEqual(note.read_text(), "<svg>mine</svg>\n")
        self.fail_with(1, "info", self.library, "--pain", self.library)
        self.fail_with(1, "info", note, "--pain", self.folder / "pain.svg")


class PainLabels(ProgramTest):
    """Pain as what train, compare and export count by."""

    def setUp(self):
        super().setUp()
        self.library = self.folder / "lib.flinchlib"
        make_library(self.library)
        self.store = self.folder / "places.flinchobs"
        self.succeed("simulate", self.library, "--out", self.store, "-n", 60, "--places")

    def exported(self, *options):
        out = self.folder / "out.csv"
        self.succeed("export", self.store, "--out", out, "--force", *options)
        return out.read_text()

    def test_a_store_with_places_has_the_trials_of_one_without_and_says_so(self):
        plain = self.folder / "plain.flinchobs"
        self.succeed("simulate", self.library, "--out", plain, "-n", 60)
        with sqlite3.connect(self.store) as a, sqlite3.connect(plain) as b:
            trials = "SELECT trials FROM observation ORDER BY number"
            self.assertEqual(a.execute(trials).fetchall(), b.execute(trials).fetchall())
            self.assertEqual(b.execute("SELECT sum(length(places)) FROM observation").fetchone(),
                             (0,))
            stored = a.execute("SELECT sum(length(places)) FROM observation").fetchone()[0]
        document = self.document("info", self.store)
        self.assertTrue(document["keeps_places"])
        self.assertEqual(13 * document["places"], stored)
        self.assertIn(f"at {document['places']} places", self.succeed("info", self.store).stdout)
        self.assertFalse(self.document("info", plain)["keeps_places"])
        self.assertIn("without --places", self.fail_with(
            1, "merge", self.store, plain, "--out", self.folder / "merged"))

    def test_selectors_count_pain_and_tell(self):
        selector = self.folder / "pain.flinch"
        document = self.document("train", self.store, "--out", selector, "--model", "knn",
                                 "--pain", "thesis")
        self.assertEqual(document["vulnerability"], "pain")
        document = self.document("info", selector)
        self.assertEqual(document["vulnerability_name"], "pain")
        self.assertEqual(document["vulnerability"]["head"], 1)
        self.assertAlmostEqual(document["vulnerability"]["chest"], 2 / 15)
        self.succeed("select", selector, "--azimuth", 10, "--look-ahead", 4)
        compared = self.document("compare", self.store, "--models", "knn", "--pain", "thesis")
        self.assertEqual(compared["cost_model"]["vulnerability_name"], "pain")

    def test_a_map_of_ones_counts_as_uniform_vulnerability_and_the_thesis_does_not(self):
        ones = self.folder / "ones.toml"
        regions = ("eyes nose face head neck chest stomach pelvis upper_arm forearm_inside "
                   "forearm_outside palm back_of_hand thigh shin foot").split()
        ones.write_text("[multipliers]\n" + "".join(f"{name} = 1\n" for name in regions))

        def best(text):
            rows = [line.split(",") for line in text.splitlines()]
            return [row[rows[0].index("label")] for row in rows]
        uniform = best(self.exported("--vulnerability", "uniform"))
        self.assertEqual(best(self.exported("--pain", ones)), uniform)
        self.assertNotEqual(best(self.exported("--pain", "thesis")), uniform)

    def test_refuses_what_does_not_fit_together(self):
        out = self.folder / "out.flinch"
        plain = self.folder / "plain.flinchobs"
        self.succeed("simulate", self.library, "--out", plain, "-n", 4)
        self.assertIn(f"{plain}: keeps no places of hits, which --pain needs; simulate it again "
                      "with --places",
                      self.fail_with(1, "train", plain, "--out", out, "--pain", "thesis"))
        self.assertIn("give one of them",
                      self.fail_with(1, "train", self.store, "--out", out, "--pain", "thesis",
                                     "--vulnerability", "blunt"))
        wrong = self.folder / "wrong.toml"
        wrong.write_text("[multipliers]\nteeth = 3\n")
        line = self.fail_with(1, "compare", self.store, "--pain", wrong)
        self.assertIn(f"{wrong}:2: ", line)
        self.assertIn("the regions are: eyes, nose, face", line)


class Evolve(ProgramTest):
    """Small runs: the pose matters little, what happens to files does."""
    SMALL = ["--azimuth", 30, "--population", 24, "--generations", 4]

    def setUp(self):
        super().setUp()
        self.library = self.folder / "default.flinchlib"
        authored = shared_folder() / "default.flinchlib"
        if not authored.exists():
            self.succeed("author", "--out", authored)
        shutil.copy(authored, self.library)
        self.out = self.folder / "evolved.flinchlib"
        self.log = self.folder / "run.csv"

    def test_adds_a_clip_that_hurts_less_than_standing_still(self):
        document = self.document("evolve", self.library, "--out", self.out, "--log", self.log,
                                 *self.SMALL)
        self.assertEqual(document["kind"], "evolution")
        self.assertEqual(document["generations"], 4)
        self.assertEqual(document["encounters"], 4 * 24 * 36)
        self.assertLess(document["pain_share"], 1)
        self.assertAlmostEqual(document["pain_share"],
                               document["pain_ns"] / document["idle_pain_ns"])
        before = self.document("info", self.library)["clips"]
        after = self.document("info", self.out, "--quality")
        self.assertEqual([c["name"] for c in after["clips"]],
                         [c["name"] for c in before] +
                         ["evolved_head_30_free", "evolved_head_30_free_mirrored"])
        for row in after["quality"]["clips"]:
            if row["name"].startswith("evolved"):
                self.assertEqual(row["breaks"], [], row)
        lines = self.log.read_text().splitlines()
        self.assertEqual(len(lines), 5)
        self.assertEqual(lines[0], "generation,best_fitness_ns,mean_fitness_ns,check_fitness_ns,"
                         "poses,encounters")
        for number, line in enumerate(lines[1:]):
            cells = line.split(",")
            self.assertEqual(int(cells[0]), number)
            self.assertLess(float(cells[1]), float(cells[2]))
            self.assertEqual(int(cells[5]), (number + 1) * 24 * 36)
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["default.flinchlib", "evolved.flinchlib", "run.csv"])

    def test_gives_the_same_bytes_on_any_number_of_threads_and_after_interruptions(self):
        expected = self.folder / "expected.flinchlib"
        self.succeed("evolve", self.library, "--out", expected, "--threads", 2, *self.SMALL)
        command = [FLINCH, "evolve", str(self.library), "--out", str(self.out), "--threads", "1",
                   *map(str, self.SMALL)]
        unfinished = self.folder / "evolved.flinchlib.evolution"
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as running:
            for _ in range(6000):
                if unfinished.exists() or running.poll() is not None:
                    break
                time.sleep(0.01)
            running.send_signal(signal.SIGINT)
            error = running.communicate()[1]
        self.assertEqual(running.returncode, 1, error)
        self.assertIn("generations are kept, run the same command again to continue", error)
        self.assertFalse(self.out.exists())
        pain = self.folder / "pain.toml"
        pain.write_text("[multipliers]\nnose = 3\n")
        for other in [("--seed", 2), ("--azimuth", 31), ("--elevation", 1), ("--speed", 26),
                      ("--target", "trunk"), ("--style", "far"), ("--tournament", 8),
                      ("--mutation", "B"), ("--gene-map", "full_turn"), ("--pain", pain),
                      ("--failed-joints", "limp"), ("--limit-weight", 1),
                      ("--extension-weight", 1)]:
            with self.subTest(other):
                options = dict(zip(self.SMALL[::2], self.SMALL[1::2])) | dict([other])
                line = self.fail_with(1, "evolve", self.library, "--out", self.out,
                                      *(text for pair in options.items() for text in pair))
                self.assertIn("with other options is unfinished here", line)
        self.succeed(*command[1:])
        self.assertEqual(self.out.read_bytes(), expected.read_bytes())
        self.assertFalse(unfinished.exists())

    def test_reads_genes_as_angles_of_a_full_turn_if_asked(self):
        small = ["--population", 8, "--generations", 1]
        for name, options in [("limits", []), ("also_limits", ["--gene-map", "limits"]),
                              ("turned", ["--gene-map", "full_turn"])]:
            self.succeed("evolve", self.library, "--out", self.folder / name, *small, *options)
        limits = (self.folder / "limits").read_bytes()
        self.assertEqual((self.folder / "also_limits").read_bytes(), limits)
        self.assertNotEqual((self.folder / "turned").read_bytes(), limits)

    def test_runs_the_character_of_the_thesis(self):
        self.succeed("author", "--character", "waist_up_man", "--out", self.library, "--force")
        thesis = ["--azimuth", 30, "--population", 12, "--generations", 2, "--figure", "waist_up",
                  "--failed-joints", "limp"]
        document = self.document("evolve", self.library, "--out", self.out, *thesis)
        self.assertLess(document["pain_share"], 1)
        self.assertEqual(document["clip_count"],
                         len(self.document("info", self.library)["clips"]) + 2)
        again = self.folder / "again.flinchlib"
        self.succeed("evolve", self.library, "--out", again, "--threads", 1, *thesis)
        self.assertEqual(again.read_bytes(), self.out.read_bytes())
        stores = [self.folder / "people.flinchobs", self.folder / "waist_up.flinchobs"]
        self.succeed("simulate", self.library, "--out", stores[0], "-n", 8)
        self.succeed("simulate", self.library, "--out", stores[1], "-n", 8, "--figure", "waist_up")
        self.assertEqual(self.document("info", stores[1])["simulation"]["figure"], "waist_up")
        line = self.fail_with(1, "merge", *stores, "--out", self.folder / "merged.flinchobs")
        self.assertIn("another simulation", line)

    def test_mends_the_weakest_cells_and_reports_the_gain(self):
        make_library(self.library)
        small = ["--weakest", 2, "--scenarios", 256, "--population", 8, "--generations", 2]
        document = self.document("evolve", self.library, "--out", self.out, "--log", self.log,
                                 *small)
        self.assertEqual(document["kind"], "evolution")
        self.assertEqual(len(document["cells"]), 2)
        kept = [cell["clip"] for cell in document["cells"] if cell["clip"]]
        before = self.document("info", self.library)["clips"]
        after = self.document("info", self.out)["clips"]
        self.assertEqual(document["clip_count"], len(before) + 2 * len(kept))
        self.assertEqual([c["name"] for c in after[len(before):]],
                         [name + end for name in kept for end in ("", "_mirrored")])
        whole = document["whole_oracle"]
        self.assertEqual(whole["scenarios"], 256)
        self.assertLessEqual(whole["cost_after_ns"], whole["cost_before_ns"])
        self.assertEqual(document["cells_oracle"]["scenarios"],
                         sum(cell["oracle"]["scenarios"] for cell in document["cells"]))
        lines = self.log.read_text().splitlines()
        self.assertEqual(len(lines), 1 + 2 * 2)
        again = self.folder / "again.flinchlib"
        self.succeed("evolve", self.library, "--out", again, "--threads", 1, *small)
        self.assertEqual(again.read_bytes(), self.out.read_bytes())
        for arguments, text in [(["--azimuth", 30], "leave out --azimuth"),
                                (["--style", "hands"], "leave out --style"),
                                (["--figure", "waist_up"], "leave out --figure"),
                                (["--gene-map", "full_turn"], "leave out --gene-map"),
                                (["--failed-joints", "limp"], "leave out --failed-joints"),
                                (["--limit-weight", 1], "leave out --limit-weight"),
                                (["--extension-weight", 1], "leave out --extension-weight")]:
            self.assertIn(text, self.fail_with(2, "evolve", self.library, "--out", again, *small,
                                               *arguments))
        for arguments in (["--scenarios", 30], ["--brawn", 0.1], ["--vulnerability", "uniform"]):
            self.assertIn("is for --weakest", self.fail_with(
                2, "evolve", self.library, "--out", again, *arguments))

    def test_says_where_the_gain_could_not_be_measured(self):
        make_library(self.library)
        few = ["--weakest", 1, "--scenarios", 4, "--population", 8, "--generations", 1]
        oracle = self.document("evolve", self.library, "--out", self.out, *few)["cells"][0]["oracle"]
        self.assertEqual(oracle, {"scenarios": 0, "cost_before_ns": None, "cost_after_ns": None,
                                  "difference_ns": None, "difference_ci_ns": [None, None]})
        text = self.succeed("evolve", self.library, "--out", self.out, "--force", *few).stdout
        self.assertIn("in these cells: not measured, no fresh scenario fell into them; raise "
                      "--scenarios\n", text)
        self.assertRegex(text, r"not met +not met")
        self.assertNotIn("0.000 -> 0.000", text)

    def test_refuses_what_it_cannot_evolve_in_one_line(self):
        pain = self.folder / "pain.toml"
        pain.write_text("[multipliers]\near = 3\n")
        feet = self.folder / "feet.toml"  # of which a ball at the head is nowhere near
        feet.write_text("[multipliers]\nfoot = 1\n" + "".join(f"{name} = 0\n" for name in (
            "eyes", "nose", "face", "head", "neck", "chest", "stomach", "pelvis", "upper_arm",
            "forearm_inside", "forearm_outside", "palm", "back_of_hand", "thigh", "shin")))
        for code, arguments, text in [
                (2, ["--azimuth", 400], "not in range"),
                (2, ["--azimuth", "nan"], "not in range"),
                (2, ["--style", "polite"], "free"),
                (2, ["--speed", 1], "not in range"),
                (2, ["--figure", "robot"], "people"),
                (2, ["--failed-joints", "broken"], "idle"),
                (2, ["--gene-map", "half_turn"], "full_turn"),
                (2, ["--limit-weight", -1], "not in range"),
                (2, ["--extension-weight", "inf"], "not in range"),
                (1, ["--population", 0], "a population of 0; it must be even"),
                (1, ["--population", 401], "a population of 401; it must be even"),
                (1, ["--population", 4, "--tournament", 8], "at least as large as a tournament"),
                (1, ["--tournament", 6], "a multiple of 4"),
                (1, ["--pain", pain], f"{pain}:2: [multipliers] names a region 'ear' that does"),
                (1, ["--pain", self.folder / "none.toml"], "none.toml"),
                (1, ["--pain", feet], "standing still does not hurt")]:
            with self.subTest(arguments):
                line = self.fail_with(code, "evolve", self.library, "--out", self.out, *arguments)
                self.assertIn(text, line)
        self.assertIn("input", self.fail_with(1, "evolve", self.library, "--out", self.library))
        self.fail_with(1, "evolve", pain, "--out", self.out)
        self.assertFalse(self.out.exists())

    def test_a_character_without_arms_or_an_idle_makes_no_library_to_evolve(self):
        whole = self.folder / "whole.bvh"
        whole.write_text(takes.take(60, lambda time_s: 20))
        armless = self.folder / "armless.bvh"
        has_arm = ("Shoulder", "Arm", "Hand")
        joints = [joint for joint in takes.JOINTS if not joint[0].endswith(has_arm)]
        with unittest.mock.patch.object(takes, "JOINTS", joints):
            armless.write_text(takes.take(60, lambda time_s: 0))
        manifest = self.folder / "library.toml"
        manifest.write_text('[[clip]]\nname = "a"\nfile = "whole.bvh"\n')
        line = self.fail_with(1, "import", armless, "--out", self.out)
        for text in ("armless.bvh: ", "left_upper_arm", "map it in a TOML file"):
            self.assertIn(text, line)
        self.assertIn("has no [[idle]]: give the motion that responses start from",
                      self.fail_with(1, "import", self.folder, "--manifest", manifest,
                                     "--out", self.out))
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
