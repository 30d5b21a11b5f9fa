#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A file says what is thrown, and every later step keeps to it."""

import pathlib
import re
import sqlite3
import unittest

from flinch_program import StoreTest, run

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


def block_of(page):
    """The page's one block of TOML."""
    block, = re.findall(r"^```toml\n(.*?)^```$", (DOCS / page).read_text(), re.MULTILINE | re.DOTALL)
    return block


class Threats(StoreTest):
    scenarios = 12

    def file(self, text, name="threats.toml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def test_the_default_file_gives_the_default_store(self):
        self.make_whole()
        threats = self.file(self.succeed("threats").stdout)
        store = self.folder / "store"
        self.succeed(*self.command(store, "--threats", threats))
        # The hash is of all but the provenance, which names the file.
        self.assertEqual(self.document("info", store)["hash"], self.document("info", self.whole)["hash"])
        document = self.document("threats")
        self.assertEqual([kind["name"] for kind in document["kinds"]], ["volleyball"])
        self.assertEqual(self.document("info", store)["distribution"]["kinds"], document["kinds"])

    def test_the_page_s_kinds_are_thrown(self):
        store = self.folder / "store"
        self.succeed(*self.command(store, "--threats", self.file(block_of("threats.md")),
                                   scenarios=60))
        kinds = self.document("info", store)["distribution"]["kinds"]
        self.assertEqual([kind["name"] for kind in kinds], ["snowball", "icicle"])
        with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
            rows = database.execute("SELECT kind, target, radius_m, mass_kg FROM observation").fetchall()
            stored = database.execute("SELECT name, restitution, friction, falls FROM kind "
                                      "ORDER BY kind").fetchall()
        self.assertEqual(stored, [("snowball", 0, 0.2, 1), ("icicle", 0.7, 0.5, 0)])
        self.assertEqual({kind for kind, *_ in rows}, {0, 1})
        for kind, target, radius, mass in rows:
            if kind == 1:
                self.assertEqual(target, "head")
                self.assertAlmostEqual(radius, 0.02)
                self.assertAlmostEqual(mass, 0.05)
            else:
                self.assertTrue(0.03 <= radius <= 0.05 and 0.0599 <= mass <= 0.2001, (radius, mass))
        self.check_selector(store)
        report = self.document("compare", store, "--models", "knn")
        groups = {group["value"] for group in report["groups"] if group["group"] == "kind"}
        self.assertLessEqual(groups, {"snowball", "icicle"})
        self.assertTrue(groups)

    def check_selector(self, store):
        selector = self.folder / "selector"
        self.succeed("train", store, "--out", selector, "--model", "knn")
        info = self.document("info", selector)
        self.assertEqual(info["features"][-5:],
                         ["radius_m", "mass_kg", "log_impulse", "kind_0", "kind_1"])
        self.assertEqual([kind["name"] for kind in info["threats"]], ["snowball", "icicle"])
        self.assertEqual(info["threats"][0]["speed_mps"], [8, 20])
        self.assertEqual(info["threats"][1]["flight"], "straight")
        self.assertIn("threats: snowball, icicle", self.succeed("info", selector).stdout)
        inside = ["select", selector, "--threat", "icicle", "--elevation", 40]
        self.assertEqual(self.document(*inside, "--time-to-impact", 0.4)["outside_training"], [])
        outside, = self.document(*inside, "--time-to-impact", 0.9)["outside_training"]
        self.assertEqual((outside["name"], outside["trained"]), ("time_to_impact_s", [0.25, 0.5]))
        self.assertAlmostEqual(outside["value"], 0.9, places=6)
        text = self.succeed(*inside, "--mass", 0.06, "--speed", 30).stdout
        self.assertIn("outside training: mass_kg 0.060, trained from 0.050 to 0.050", text)
        self.assertIn("outside training: speed_mps 30.000, trained from 10.000 to 15.000", text)
        ahead = self.document(*inside, "--mass", 0.06, "--look-ahead", 4)
        self.assertEqual([number["name"] for number in ahead["outside_training"]], ["mass_kg"])
        line = self.fail_with(1, "select", selector, "--threat", "hail")
        self.assertIn("not trained for --threat hail; it knows: snowball, icicle", line)
        self.succeed("respond", selector, "--threat", "icicle", "--out", self.folder / "hit.bvh")

    def test_a_bat_a_punch_and_a_knife_go_from_the_file_to_the_response(self):
        store = self.folder / "store"
        threats = self.file(self.succeed("threats", "--name", "kinds").stdout)
        summary = self.lines(*self.command(store, "--threats", threats, scenarios=120))[-1]
        self.assertGreater(summary["hits"], 0)
        kinds = {kind["name"]: kind for kind in self.document("info", store)["distribution"]["kinds"]}
        self.assertEqual(len(kinds), 9)
        self.assertEqual((kinds["punch"]["shape"], kinds["punch"]["reach_m"]), ("fist", [0.4, 0.7]))
        self.assertEqual(kinds["thrown_knife"]["restitution"], 0)
        self.assertEqual((kinds["bat"]["length_m"], kinds["bat"]["balance"]), ([0.81, 0.87], 0.66))
        with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
            rows = database.execute(
                "SELECT shape, time_to_impact_s, stroke_starts_in_s, stroke_lasts_s, "
                "threat_velocity_x * threat_velocity_x + threat_velocity_y * threat_velocity_y + "
                "threat_velocity_z * threat_velocity_z, min_reach_m, max_reach_m "
                "FROM observation JOIN kind USING (kind)").fetchall()
        fists = [row for row in rows if row[0] == "fist"]
        self.assertGreater(len(fists), 10)
        for shape, time, starts, lasts, speed_squared, shortest, longest in rows:
            if shape == "rod":  # it follows through
                self.assertGreater(starts + lasts, time)
                continue
            if shape != "fist":
                self.assertEqual((starts, lasts), (0, 0))
                continue
            self.assertAlmostEqual(starts + lasts, time, places=5)
            self.assertTrue(shortest - 1e-5 <= lasts * speed_squared ** 0.5 <= longest + 1e-5)
        self.check_bats(store)
        selector = self.folder / "selector"
        armour = self.file('name = "armour"\n[bodies]\n' + "".join(
            f"{body} = 0.5\n" for body in ("pelvis", "abdomen", "chest", "neck", "head", "upper_arm",
                                           "forearm", "hand", "thigh", "shin", "foot"))
            + "[kind.bat]\nhead = 1\n", "armour.toml")
        self.succeed("train", store, "--out", selector, "--model", "knn", "--vulnerability", armour)
        info = self.document("info", selector)
        self.assertIn("rod_axis_x", info["features"])
        self.assertEqual((info["vulnerability"]["head"], info["vulnerability_to"]["bat"]["head"],
                          info["vulnerability_to"]["bat"]["chest"]), (0.5, 1, 0.5))
        armour.write_text(armour.read_text().replace("kind.bat", "kind.bta"))
        line = self.fail_with(1, "train", store, "--out", selector, "--force", "--vulnerability",
                              armour)
        self.assertIn("armour.toml:14: [kind.bta] is for a kind of threat that the store does not "
                      "have; it has: volleyball", line)
        report = self.document("compare", store, "--models", "knn")
        self.assertLessEqual({row["kind"] for row in report["kinds"]}, set(kinds))
        self.assertIn("knn+8", {row["name"] for row in report["kinds"]})
        self.assertEqual(len(report["cost_model"]["reference_damage_ns"]), 9)
        for kind, shape in (("bat", "rod"), ("punch", "fist"), ("thrown_knife", "blade")):
            options = [selector, "--threat", kind, "--target", "head", "--time-to-impact", 0.5]
            self.assertEqual(self.document("select", *options)["outside_training"], [])
            self.assertTrue(self.document("select", *options, "--look-ahead", 4)["candidates"])
            said = self.succeed("respond", *options, "--out", self.folder / f"{kind}.glb").stdout
            self.assertIn(f"the {shape} hits", said)

    def check_bats(self, store):
        """The bat's grip and turn give its tip more speed than it is said to strike with."""
        with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
            bats = database.execute(
                "SELECT rod_axis_x, rod_axis_y, rod_axis_z, rod_turn_x, rod_turn_y, rod_turn_z, "
                "rod_to_butt_m, rod_to_tip_m, min_length_m, max_length_m, radius_m "
                "FROM observation JOIN kind USING (kind) WHERE shape = 'rod'").fetchall()
            others, = database.execute(
                "SELECT count(*) FROM observation JOIN kind USING (kind) WHERE shape != 'rod' AND "
                "(rod_axis_x != 0 OR rod_to_tip_m != 0)").fetchone()
        self.assertGreater(len(bats), 5)
        self.assertEqual(others, 0)
        for *numbers, butt, tip, shortest, longest, radius in bats:
            axis, turn = numbers[:3], numbers[3:]
            self.assertAlmostEqual(sum(x * x for x in axis), 1, places=5)
            self.assertAlmostEqual(sum(x * y for x, y in zip(axis, turn)), 0, places=3)
            self.assertEqual(butt, 0)
            self.assertTrue(shortest - 1e-5 <= tip + 2 * radius <= longest + 1e-5)

    def test_scenarios_begin_in_the_stances_that_are_named(self):
        library = self.folder / "authored"
        self.succeed("author", "--out", library)
        store = self.folder / "store"
        command = ["simulate", library, "--out", store, "-n", 12, "--threads", 1]
        self.succeed(*command, "--stances", "all")
        with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
            stances = database.execute("SELECT DISTINCT stance FROM observation").fetchall()
        self.assertEqual(set(stances), {(0,), (1,)})
        self.assertEqual(self.document("info", store)["distribution"]["stances"],
                         [{"name": "idle", "weight": 1}, {"name": "guard", "weight": 1}])
        selector = self.folder / "selector"
        self.succeed("train", store, "--out", selector, "--model", "knn")
        self.assertIn("velocity_x", self.document("info", selector)["features"])
        groups = self.document("compare", store, "--models", "knn")["groups"]
        self.assertLessEqual({row["value"] for row in groups if row["group"] == "stance"},
                             {"idle", "guard"})
        other = self.folder / "other"
        self.succeed("simulate", library, "--out", other, "-n", 4, "--stances", "guard=3", "idle=0.5")
        line = self.fail_with(1, *command, "--stances", "guard")
        self.assertIn("another scenario distribution", line)
        line = self.fail_with(1, *command, "--stances", "gaurd")
        self.assertIn("the library has no stance gaurd; it has idle, guard", line)
        line = self.fail_with(2, *command, "--stances", "guard=-1")
        self.assertIn("a weight is above 0 and at most 1e6", line)

    def test_what_no_clip_is_made_for_is_told(self):
        self.make_whole()
        selector = self.folder / "selector"
        lines = self.document("train", self.whole, "--out", selector, "--model", "knn")["unanswered"]
        self.assertTrue(all(line.startswith("no clip is made for threats to the ")
                            for line in lines), lines)
        self.assertTrue(lines, "the synthetic library has few clips")

    def test_stores_of_other_threats_are_neither_continued_nor_merged(self):
        self.make_whole()
        before = self.whole.read_bytes()
        balls = self.file(self.succeed("threats", "--name", "balls").stdout)
        line = self.fail_with(1, *self.command(self.whole, "--threats", balls, scenarios=20))
        self.assertIn("another scenario distribution", line)
        self.assertEqual(self.whole.read_bytes(), before)
        rest = self.folder / "rest"
        self.succeed(*self.command(rest, "--threats", "balls", "--first", 12, scenarios=4))
        line = self.fail_with(1, "merge", self.whole, rest, "--out", self.folder / "all")
        self.assertIn("another scenario distribution", line)
        line = self.fail_with(1, "compare", self.whole, "--test", rest, "--models", "knn")
        self.assertIn("other kinds of threats", line)

    def test_the_largest_damage_is_that_of_the_heaviest_blow(self):
        text = '[[kind]]\nname = "a"\nmass_kg = 2\nspeed_mps = 10\nrestitution = 0.5\n'
        store = self.folder / "store"
        self.succeed(*self.command(store, "--threats", self.file(text)))
        model = self.document("compare", store, "--models", "knn")["cost_model"]
        damage, = model["reference_damage_ns"]
        self.assertAlmostEqual(damage, 1.5 * 2 * 10)

    def test_bad_files_are_refused_with_their_line(self):
        cases = {
            'x = 1\n': ":1: the file has an unknown key",
            '[[kind]]\nname = "a"\nmass_kg = -1\n': ":3: [[kind]] has mass_kg -1",
            '[[kind]]\nname = "a"\nspeed_mps = [9, 3]\n': ":3: [[kind]] has speed_mps from 9 to 3",
            '[[kind]]\nname = "a"\nweight = 0\n': "only kinds of weight 0",
            '[[kind]]\nspeed_mps = 3\n': "needs name",
            '[[kind]]\nname = "a"\nshape = "rod"\nlength_m = 6\n': ":4: [[kind]] has length_m 6, which is "
                                                                "not from 0.05 to 5 m",
            '[[kind\n': ":1: not TOML",
        }
        for text, words in cases.items():
            with self.subTest(text):
                path = self.file(text)
                line = self.fail_with(1, *self.command(self.folder / "store", "--threats", path))
                self.assertTrue(line.startswith(f"flinch: {path}:"), line)
                self.assertIn(words, line)
        self.assertIn("--threats", self.fail_with(2, *self.command("store", "--threats", "cats")))
        path = self.file('[[kind]]\nname = "a"\n')
        self.assertIn("is an input", self.fail_with(1, *self.command(path, "--threats", path)))
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["threats.toml"])
        low = self.file('[[kind]]\nname = "low"\nspeed_mps = 1\ntime_to_impact_s = 10\n')
        done = run(*self.command(self.folder / "store", "--threats", low))
        self.assertEqual(done.returncode, 1)
        self.assertIn("no low of the distribution stays above the ground", done.stderr)


if __name__ == "__main__":
    unittest.main()
