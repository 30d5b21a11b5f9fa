#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The animation that answers a threat, in every format, from one selector file."""

import json
import os
import pathlib
import re
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

    def test_starts_from_the_guard_and_returns_to_it(self):
        _, idle = self.respond("idle.bvh")
        out, guard = self.respond("guard.bvh", *THREAT, "--start", "guard")
        self.assertNotEqual(out.read_bytes(), (self.folder / "idle.bvh").read_bytes())
        self.assertGreater(guard["duration_s"], 1)
        line = self.fail_with(1, "respond", self.selector, "--start", "walk", "--out",
                              self.folder / "walk.bvh")
        self.assertIn("has no stance walk for --start; it has: idle, guard", line)

    def test_answers_with_a_clip_of_choice(self):
        clip = "duck_head_front_exaggerated"
        _, played = self.respond("clip.bvh", *THREAT, "--clip", clip)
        self.assertEqual(played["clip"], clip)
        line = self.fail_with(1, "respond", self.selector, "--clip", "guard", "--out",
                              self.folder / "none.bvh")
        self.assertIn("has no clip guard that answers threats", line)

    def test_a_late_answer_leaves_the_beginning_as_it_was(self):
        def poses(name, *options):
            out, document = self.respond(name, *THREAT, "--clip", "duck_head_front_exaggerated",
                                         *options)
            lines = out.read_text().split("Frame Time")[1].splitlines()[1:]
            return lines, document
        at_once, _ = poses("at_once.bvh")
        late, document = poses("late.bvh", "--reaction-delay", 0.4)
        self.assertEqual(document["clip"], "duck_head_front_exaggerated")
        self.assertNotEqual(at_once[20], at_once[0])
        self.assertNotEqual(late[20], at_once[20])
        unnoticed, document = poses("unnoticed.bvh", "--failure", 1)
        self.assertFalse(document["noticed"])
        self.assertEqual(late[:24], unnoticed[:24])

    def test_noise_changes_what_is_chosen_by_its_seed_alone(self):
        def chosen(seed):
            return self.document("respond", self.selector, *THREAT, "--noise", 10, "--seed", seed,
                                 "--out", self.folder / f"{seed}.bvh")["clip"]
        clips = [chosen(seed) for seed in range(8)]
        self.assertGreater(len(set(clips)), 1)
        self.assertEqual(chosen(3), clips[3])

    def test_answers_by_rule_from_any_motion_without_a_selector(self):
        _, ruled = self.respond("ruled.bvh", *THREAT, "--rules", "--startle")
        self.assertEqual(ruled["clip"], "by rule")
        walk, out = self.folder / "ruled.bvh", self.folder / "walked.glb"
        played = self.document("respond", "--motion", walk, "--at", 0.2, *THREAT, "--out", out)
        self.assertEqual((played["clip"], played["target"]), ("by rule", "head"))
        line = self.fail_with(1, "respond", "--motion", walk, "--at", 60, "--out", out)
        self.assertIn("--at must be a moment of it", line)
        self.assertIn("needs a SELECTOR or --motion", self.fail_with(2, "respond", "--out", out))

    def test_a_second_threat_is_answered_and_hits(self):
        _, both = self.respond("both.glb", *THREAT, "--second-time-to-impact", 1.1,
                               "--second-azimuth", -60, "--second-target", "trunk", "--end", "idle")
        self.assertIn("hits", both["second"])
        line = self.fail_with(1, "respond", self.selector, *THREAT, "--second-time-to-impact", 0.4,
                              "--out", self.folder / "no.glb")
        self.assertIn("must be later than --time-to-impact", line)

    def test_balls_move_nothing_where_the_end_is_none(self):
        hard = ["--target", "trunk", "--speed", 12, "--time-to-impact", 0.05, "--mass", 20,
                "--radius", 0.15]
        _, hit = self.respond("hit.bvh", *hard)
        _, free = self.respond("free.bvh", *hard, "--end", "none")
        self.assertTrue(hit["knocked_over"])
        self.assertFalse(free["knocked_over"])
        self.assertFalse(free["hits"])

    def test_the_filmstrip_points_at_the_target(self):
        def arrow_height(target):
            out, _ = self.respond(f"{target}.svg", "--azimuth", 40, "--target", target, "--clip",
                                  "duck_head_front_exaggerated")
            return float(re.search(r"d='M\S+ (\S+)L\S+ \S+' stroke='#c00'", out.read_text())[1])
        head, trunk, legs = map(arrow_height, ("head", "trunk", "legs"))
        self.assertLess(head, trunk - 20)
        self.assertLess(trunk, legs - 20)

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

    def test_a_selector_without_clips_answers_by_the_library_beside_it(self):
        made = pathlib.Path(self.made.name)
        bare = self.folder / "bare.flinch"
        self.succeed("train", made / "default.flinchobs", "--out", bare, "--model", "knn",
                     "--without-clips")
        library_size = (made / "default.flinchlib").stat().st_size
        self.assertLess(bare.stat().st_size, self.selector.stat().st_size - library_size // 2)
        shown = self.document("info", bare)
        whole = self.document("info", self.selector)
        self.assertFalse(shown["has_clips"])
        self.assertEqual(shown["library_hash"], whole["library_hash"])
        self.assertEqual(shown["provenance"]["options"]["without-clips"], "true")
        self.assertEqual(self.succeed("select", bare, *THREAT).stdout,
                         self.succeed("select", self.selector, *THREAT).stdout)
        for command in (["respond", bare, *THREAT, "--out", self.folder / "a.glb"],
                        ["select", bare, *THREAT, "--look-ahead", 2]):
            line = self.fail_with(1, *command)
            self.assertIn(f"{bare}: the selector has no clips", line)
            self.assertIn(whole["library_hash"], line)
        self.succeed("author", "--out", self.folder / "a.flinchlib", "--startle")
        self.assertIn(whole["library_hash"], self.fail_with(1, *command))
        (self.folder / "b.flinchlib").write_bytes((made / "default.flinchlib").read_bytes())
        played = self.folder / "bare.glb"
        self.document("respond", bare, *THREAT, "--out", played)
        expected, _ = self.respond("whole.glb")
        self.assertEqual(played.read_bytes(), expected.read_bytes())
        self.assertIn("has no clips, which a page needs",
                      self.fail_with(1, "view", bare, "--out", self.folder / "page"))


if __name__ == "__main__":
    unittest.main()
