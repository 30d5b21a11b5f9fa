#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The animation that answers a threat, in every format, from one selector file."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from flinch_program import ProgramTest

VALIDATE = pathlib.Path(__file__).resolve().parents[1] / "gltf" / "validate.mjs"
NODE = pathlib.Path(os.environ["FLINCH_NODE"])
THREAT = ["--azimuth", 40, "--speed", 24, "--target", "head", "--time-to-impact", 0.5]


class Respond(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.made.cleanup)
        folder = pathlib.Path(cls.made.name)
        cls.selector = folder / "default.flinch"
        maker = ProgramTest("succeed")
        library, store = folder / "default.flinchlib", folder / "default.flinchobs"
        maker.succeed("author", "--out", library)
        maker.succeed("simulate", library, "--out", store, "-n", 24)
        maker.succeed("train", store, "--out", cls.selector, "--model", "knn")

    def respond(self, name, *threat):
        out = self.folder / name
        document = self.document("respond", self.selector, *(threat or THREAT), "--out", out)
        self.assertEqual(document["file"], str(out))
        return out, document

    def test_plays_what_select_chooses_until_the_character_idles_again(self):
        _, played = self.respond("hit.glb")
        chosen = self.document("select", self.selector, *THREAT)
        self.assertEqual(played["clip"], chosen["clip"])
        self.assertEqual(played["target"], "head")
        self.assertGreater(played["duration_s"], 1)
        self.assertFalse(played["knocked_over"])

    def test_looking_ahead_takes_the_cheapest_of_the_first_candidates(self):
        plain = self.document("select", self.selector, *THREAT)
        one = self.document("select", self.selector, *THREAT, "--look-ahead", 1)
        self.assertEqual(one["clip"], plain["clip"])
        ahead = self.document("select", self.selector, *THREAT, "--look-ahead", 8)
        self.assertEqual(ahead["candidates"][0]["clip"], plain["clip"])
        self.assertGreater(len(ahead["candidates"]), 1)
        known = {candidate["clip"]: candidate["cost_ns"] for candidate in ahead["candidates"]}
        self.assertEqual(known[ahead["clip"]], min(known.values()))
        _, played = self.respond("ahead.glb", *THREAT, "--look-ahead", 8)
        self.assertEqual(played["clip"], ahead["clip"])
        text = self.succeed("select", self.selector, *THREAT, "--look-ahead", 8).stdout
        self.assertTrue(text.startswith(ahead["clip"] + ": "), text)

    def test_same_threat_same_bytes(self):
        for name in ("a.glb", "a.bvh", "a.svg"):
            first, _ = self.respond(name)
            again, _ = self.respond("again" + name)
            self.assertEqual(first.read_bytes(), again.read_bytes())

    def test_a_heavy_ball_knocks_over_and_a_volleyball_does_not(self):
        threat = ["--target", "trunk", "--speed", 12, "--time-to-impact", 0.05]
        _, light = self.respond("light.glb", *threat)
        _, heavy = self.respond("heavy.glb", *threat, "--mass", 20, "--radius", 0.15)
        self.assertFalse(light["knocked_over"])
        self.assertTrue(heavy["hits"])
        self.assertTrue(heavy["knocked_over"])
        self.assertGreater(heavy["impulse_ns"], 50)

    def test_the_animation_tells_its_clip_and_its_hit(self):
        out, document = self.respond("hit.glb", "--target", "trunk", "--speed", 12,
                                     "--time-to-impact", 0.2)
        data = out.read_bytes()
        size = int.from_bytes(data[12:16], "little")
        extras = json.loads(data[20:20 + size])["animations"][0]["extras"]
        self.assertTrue(document["hits"])
        for key in ("clip", "hit_body"):
            self.assertEqual(extras[key], document[key])
        for key in ("contact_s", "impulse_ns"):
            self.assertAlmostEqual(extras[key], document[key], places=4)
        self.assertEqual(extras["impact_s"], 0.2)

    def test_bvh_is_read_back_by_our_own_reader(self):
        out, document = self.respond("hit.bvh")
        info = self.document("info", out)
        self.assertEqual(info["kind"], "bvh")
        self.assertAlmostEqual(info["duration_s"], document["duration_s"], delta=0.05)

    def test_gltf_is_read_back_as_gltf(self):
        out, _ = self.respond("hit.glb")
        self.assertEqual(self.document("info", out)["kind"], "gltf")
        made = self.document("import", out, "--out", self.folder / "hit.flinchlib")
        self.assertEqual([source["kind"] for source in made["sources"]], ["gltf"])

    def test_gltf_validator_finds_nothing(self):
        self.respond("hit.glb")
        done = subprocess.run(["node", VALIDATE, NODE, self.folder], capture_output=True,
                              text=True, check=False)
        if done.returncode == 77:
            self.skipTest(done.stdout)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_refuses_other_formats_and_files_without_clips(self):
        line = self.fail_with(1, "respond", self.selector, "--out", self.folder / "hit.fbx")
        self.assertIn(".glb, .bvh or .svg", line)
        damaged = self.folder / "damaged.flinch"
        data = bytearray(self.selector.read_bytes())
        data[len(data) // 2] ^= 1
        damaged.write_bytes(data)
        line = self.fail_with(1, "respond", damaged, "--out", self.folder / "hit.glb")
        self.assertIn(str(damaged), line)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["damaged.flinch"])


if __name__ == "__main__":
    unittest.main()
