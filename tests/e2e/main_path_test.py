#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From a library to a chosen clip, with a library that needs no motion capture."""

import csv
import json
import pathlib
import re
import shutil
import sqlite3
import subprocess
import unittest

from flinch_program import FLINCH, ProgramTest, make_library
from store_costs import costs

SCENARIOS = 48
COMMANDS = ["author", "import", "info", "simulate", "train", "compare", "export", "select", "respond",
            "threats"]


class MainPath(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "a.flinchlib"
        self.store = self.folder / "a.flinchobs"
        self.selector = self.folder / "a.flinch"
        make_library(self.library)

    def simulate(self):
        self.succeed("simulate", self.library, "--out", self.store, "-n", SCENARIOS)

    def test_from_library_to_clip(self):
        library = self.document("info", self.library)
        clips = [c["name"] for c in library["clips"]]
        done = self.lines("simulate", self.library, "--out", self.store, "-n", SCENARIOS)[-1]
        self.assertEqual(done["scenarios"], SCENARIOS)
        for model in ("knn", "svm", "knn_cost", "network", "pairwise_cost"):
            made = self.document("train", self.store, "--out", self.selector, "--model", model)
            self.assertEqual(made["warnings"],
                             ["48 scenarios are too few to trust the selector; simulate at least 200"])
            self.check_description(self.document("info", self.selector), model, library)
            for target in ("head", "trunk", "pelvis", "legs"):
                answer = self.document("select", self.selector, "--azimuth", 40, "--speed", 24,
                                       "--target", target, "--time-to-impact", 0.5)
                self.assertIn(answer["clip"], clips)
                self.assertEqual(answer["target"], target)
                self.assertEqual(answer["time_to_impact_s"], 0.5)
                self.assertEqual(answer["candidates"][0]["clip"], answer["clip"])
                by_votes = model in ("knn", "svm", "pairwise_cost")
                ranks = [-c["vote"] if by_votes else c["expected_cost_ns"]
                         for c in answer["candidates"]]
                self.assertEqual(ranks, sorted(ranks))
            text = self.succeed("select", self.selector, "--target", "legs").stdout
            self.assertIn("vote" if by_votes else "expected cost, N s", text)
        self.check_comparison()
        self.check_export()

    def check_description(self, selector, model, library):
        self.assertEqual(selector["model"], model)
        self.assertTrue(selector["has_clips"])
        self.assertEqual(selector["library"], library["name"])
        self.assertEqual(selector["library_hash"], library["hash"])
        self.assertEqual([c["name"] for c in selector["clips"]],
                         [c["name"] for c in library["clips"]])
        poses = [round(c["duration_s"] * library["rate_hz"]) + 1 for c in library["clips"]]
        self.assertEqual(selector["poses"], sum(poses))
        # The selector's file contains the library's file, without its provenance.
        with sqlite3.connect(self.store) as store:
            (file,), = store.execute("SELECT file FROM library")
        self.assertIn(file, self.selector.read_bytes())
        store, = selector["provenance"]["inputs"]
        self.assertEqual(store["provenance"]["inputs"], [{"role": "library", "hash": library["hash"]}])

    def check_comparison(self):
        report = self.folder / "report"
        # Says on stderr if there is no page.
        document = json.loads(self.succeed("compare", self.store, "--report", report, "--json").stdout)
        timing = document.pop("timing")
        self.assertEqual(document, json.loads((report / "report.json").read_text()))
        names = [row["name"] for row in document["rows"]]
        self.assertEqual(names[:3] + names[-1:], ["idle", "random", "nearest_annotation", "oracle"])
        self.assertEqual(names[3], "rules")  # a response, not a choice, so it has no time
        ahead = {row["name"]: row for row in document["look_ahead"]}
        self.assertEqual(names[4:-1] + list(ahead), [row["name"] for row in timing])
        self.assertLessEqual({"network+2", "network+4", "network+8", "network+16", "svm+8", "knn+8",
                              "pairwise_cost+8", "nearest_annotation+8", "random+8"}, set(ahead))
        costs_of_rows = {row["name"]: row["mean_cost"] for row in document["rows"]}
        for name in ("random", "nearest_annotation"):
            self.assertLess(ahead[name + "+8"]["mean_cost"], costs_of_rows[name])
        self.assertGreater(ahead["network+16"]["protection"], 0.95)
        self.assertEqual([row["brawn"] for row in document["brawn"]],
                         [0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1])
        self.assertAlmostEqual(document["brawn"][-1]["idle"], 1)  # all that counts is work
        damages = [row["mean_damage"] for row in document["brawn"]]
        self.assertLess(damages[0], damages[-1])
        self.assertLessEqual({"knn", "svm"}, set(names))
        model = document["cost_model"]
        known = costs(self.store, model["vulnerability"], model["brawn"])
        means = {row["name"]: 0 for row in document["rows"]}
        with open(report / "scenarios.csv", newline="") as file:
            lines = list(csv.DictReader(file))
        self.assertEqual([int(line["number"]) for line in lines], list(range(3, SCENARIOS, 4)))
        for line in lines:
            of_clip = known[int(line["number"])]
            for name in means:
                cost = float(line[name + "_cost_ns"])
                if name != "rules":  # which plays no clip
                    self.assertAlmostEqual(of_clip[int(line[name + "_clip"])], cost, delta=1e-9)
                means[name] += cost / len(lines)
            self.assertLessEqual(float(line["oracle_cost_ns"]), min(of_clip.values()) * 1.01 + 1e-12)
        for row in document["rows"]:
            self.assertAlmostEqual(row["mean_cost"], means[row["name"]], delta=1e-9)
            self.assertAlmostEqual(row["regret"], means[row["name"]] - means["oracle"], delta=1e-9)

    def test_comparing_on_another_store_is_repeatable(self):
        self.simulate()
        test = self.folder / "test.flinchobs"
        self.succeed("simulate", self.library, "--out", test, "-n", 20, "--seed", 2)
        reports = []
        for name in ("once", "again"):
            report = self.folder / name
            text = self.succeed("compare", self.store, "--test", test, "--models", "knn", "--report",
                                report, "--ablation", "--transfer", "--curves").stdout
            self.assertIn("tested on 20 scenarios; fitted to: 48", text)
            reports.append({p.name: p.read_bytes() for p in report.iterdir()
                            if p.name != "timing.json" and p.suffix != ".html"})
        self.assertEqual(reports[0], reports[1])
        for chart in ("groups", "reliability", "noise", "curves", "transfer", "ablation"):
            with open(self.folder / "once" / f"{chart}.csv", newline="") as file:
                self.assertGreater(len(list(csv.DictReader(file))), 0, chart)
        line = self.fail_with(1, "compare", self.store, "--test", self.store)
        self.assertIn("shares scenarios", line)

    def check_export(self):
        table = self.folder / "a.csv"
        self.succeed("export", self.store, "--out", table)
        with open(table, newline="") as file:
            lines = list(csv.DictReader(file))
        self.assertEqual(len(lines), SCENARIOS)
        self.assertEqual(lines[5]["number"], "5")
        data = self.folder / "a.libsvm"
        self.succeed("export", self.store, "--out", data)
        labels = [line.split()[0] for line in data.read_text().splitlines()]
        self.assertEqual(labels, [line["label"] for line in lines])
        if shutil.which("svm-train") is None:
            return
        # The selector's SVM and svm-train's on the exported text have the same support vectors.
        parameters = self.document("train", self.store, "--model", "svm", "--out", self.selector)
        svm = parameters["parameters"]
        model = self.folder / "libsvm.model"
        subprocess.run(["svm-train", "-q", "-t", "1", "-d", str(svm["degree"]), "-g",
                        repr(svm["gamma"]), "-r", repr(svm["coef0"]), "-c", repr(svm["c"]),
                        str(data), str(model)], check=True)
        header = dict(line.split(" ", 1) for line in
                      model.read_text().partition("\nSV\n")[0].splitlines())
        self.assertEqual(int(header["total_sv"]), parameters["support_vectors"])
        self.assertEqual(int(header["nr_class"]), parameters["classes"])

    def test_every_command_has_help_with_an_example(self):
        for command in COMMANDS:
            text = self.succeed(command, "--help").stdout
            self.assertRegex(text, rf"Examples?:\n  flinch {command} ")
            self.assertIn("--json", text)
        text = self.succeed("--help").stdout
        for command in COMMANDS:
            self.assertIn(command, text)
        self.assertRegex(self.succeed("--version").stdout, r"^flinch \d+\.\d+\.\d+\n$")

    def test_relabelling_needs_no_simulation(self):
        self.simulate()
        idle = {}
        for brawn in (0, 1):
            table = self.folder / "labels.csv"
            self.succeed("export", self.store, "--out", table, "--brawn", brawn)
            with open(table, newline="") as file:
                idle[brawn] = sum(line["clip"] == "idle" for line in csv.DictReader(file))
        self.assertEqual(idle[1], SCENARIOS)
        self.assertLess(idle[0], SCENARIOS)

    def test_a_table_of_ones_own_says_what_hurts(self):
        self.simulate()
        table = self.folder / "armour.toml"
        page = pathlib.Path(__file__).resolve().parents[2] / "docs/cost.md"
        text, of_bats = re.findall(r"^```toml\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)
        table.write_text(text)
        trained = self.document("train", self.store, "--out", self.selector, "--model", "knn",
                                "--vulnerability", table)
        self.assertEqual(trained["vulnerability"], "armour")
        selector = self.document("info", self.selector)
        self.assertEqual(selector["vulnerability_name"], "armour")
        self.assertEqual([selector["vulnerability"][body] for body in
                          ("head", "chest", "left_hand", "right_hand", "left_foot", "right_foot")],
                         [0.3, 0.1, 0.1, 0.2, 0.4, 0.4])
        self.assertIn("vulnerability_name: armour", self.succeed("info", self.selector).stdout)
        model = self.document("compare", self.store, "--models", "knn", "--vulnerability",
                              table)["cost_model"]
        self.assertEqual(model["vulnerability_name"], "armour")
        self.assertEqual(model["vulnerability"], selector["vulnerability"])
        table.write_text(text + of_bats)
        line = self.fail_with(1, "train", self.store, "--out", self.selector, "--vulnerability", table)
        self.assertIn("[kind.bat] is for a kind of threat that the store does not have", line)
        for name in ("default", "uniform", "blade", "blunt"):
            self.succeed("train", self.store, "--out", self.selector, "--model", "knn",
                         "--vulnerability", name)
            self.assertEqual(self.document("info", self.selector)["vulnerability_name"], name)

    def test_training_again_gives_the_same_bytes(self):
        self.simulate()
        once, again = self.folder / "once", self.folder / "again"
        self.succeed("train", self.store, "--out", once)
        self.succeed("train", self.store, "--out", again)
        self.assertEqual(once.read_bytes(), again.read_bytes())

    def test_a_closed_output_is_an_error(self):
        with open("/dev/full", "w") as full:
            process = subprocess.run([FLINCH, "info", str(self.library)], stdout=full,
                                     stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(process.returncode, 1)
        self.assertIn("standard output", process.stderr)


if __name__ == "__main__":
    unittest.main()
