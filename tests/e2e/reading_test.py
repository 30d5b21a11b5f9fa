#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Motion capture as exporters write it: every command reads the same file the same way, and tells
what it guessed."""

import json
import unittest

from flinch_program import ProgramTest, run
from takes import take

STANDING = take(60, lambda time_s: 0)


class Reading(ProgramTest):
    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def info(self, name, content):
        document = self.document("info", self.file(name, content))
        self.assertEqual(document.pop("file"), str(self.folder / name))
        return document

    def test_what_stands_around_the_text_does_not_matter(self):
        expected = self.info("plain.bvh", STANDING)
        self.assertEqual(expected["warnings"], [])
        end_site = "End Site { OFFSET 0 18 0 }"
        self.assertIn(end_site, STANDING)
        variants = {
            "byte-order mark and CRLF": "\ufeff" + STANDING.replace("\n", "\r\n"),
            "blank lines": "\n \n\t\n" + STANDING,
            "comments": "# by a tool\n" + STANDING.replace("MOTION", "# now:\nMOTION"),
            "many comments": "# by a tool\n" * 4000 + STANDING,
            "channels": STANDING.replace(end_site, "End Site { OFFSET 0 18 0 CHANNELS 0 }"),
        }
        for name, text in variants.items():
            with self.subTest(name):
                self.assertEqual(self.info(f"{name}.bvh", text), expected)
                self.succeed("import", self.folder / f"{name}.bvh", "--out", self.folder / "out")

    def test_rows_that_are_not_as_many_as_declared_are_read_with_a_note(self):
        for declared in (59, 61):
            path = self.file("rows.bvh", STANDING.replace("Frames: 60", f"Frames: {declared}"))
            with self.subTest(declared=declared):
                document = self.document("info", path)
                self.assertEqual(document["frame_count"], 60)
                self.assertEqual(len(document["warnings"]), 1)
                self.assertIn(f"declares {declared} frames", document["warnings"][0])
                done = self.succeed("import", path, "--out", self.folder / "out")
                self.assertIn(f"note: {document['warnings'][0]}\n", done.stderr)

    def test_a_library_does_not_tell_where_its_files_were(self):
        libraries = []
        for place in ("here", "there"):
            folder = self.folder / place / "takes"
            for part in ("a", "b"):
                (folder / part).mkdir(parents=True)
                (folder / part / "idle.bvh").write_text(STANDING)
            for spelling in (folder, f"{folder}/", f"{folder}/../takes"):
                out = self.folder / f"{len(libraries)}.flinchlib"
                self.succeed("import", spelling, "--out", out)
                libraries.append(out.read_bytes())
        self.assertEqual(set(libraries), {libraries[0]})
        document = self.document("info", self.folder / "0.flinchlib")
        self.assertEqual(document["name"], "takes")
        self.assertEqual({(clip["name"], clip["source"]) for clip in document["clips"]},
                         {("a/idle", "a/idle.bvh"), ("b/idle", "b/idle.bvh")})

    def test_frames_and_their_rate_can_be_chosen(self):
        path = self.file("take.bvh", STANDING)
        chosen = self.document("info", path, "--frames", "11:", "--rate-of-file", 120)
        self.assertEqual((chosen["first_frame"], chosen["frame_count"]), (11, 50))
        self.assertAlmostEqual(chosen["duration_s"], 49 / 120)
        self.assertEqual(self.document("info", path, "--skip-first")["first_frame"], 2)
        self.assertIn("59 frames from frame 2", self.succeed("info", path, "--skip-first").stdout)
        out = self.folder / "out"
        made = self.document("import", path, "--out", out, "--frames", "31:60")
        self.assertAlmostEqual(made["clips"][0]["duration_s"], 29 / 30, delta=1 / 60)
        self.assertIn("has 60 frames", self.fail_with(1, "info", path, "--frames", "50:61"))
        for text in ("5", "9:2", "0:9", "a:b"):
            self.assertIn("FIRST:LAST", self.fail_with(2, "info", path, "--frames", text))

    def test_one_number_cannot_cost_more_than_its_file(self):
        limits = {"timeout": 10}
        for number in ("1e-9", "1e-300", "1e6", "1e300"):
            path = self.file("take.bvh", STANDING.replace("Frame Time: 0.0333333",
                                                          f"Frame Time: {number}"))
            draft = self.folder / "draft.toml"
            for command in (["info", path], ["import", path, "--out", self.folder / "out"],
                            ["annotate", path, "--out", draft]):
                with self.subTest(number=number, command=command[0]):
                    self.assertIn("--rate-of-file", self.fail_with(1, *command, **limits))
            self.succeed("info", path, "--rate-of-file", 30)
        path = self.file("take.bvh", STANDING.replace("Frames: 60", "Frames: 2147483647"))
        self.assertIn("declares 2147483647 frames", self.fail_with(1, "info", path, **limits))
        manifest = self.file("m.toml", '[[idle]]\nname = "a"\nfile = "plain.bvh"\n'
                             "[library]\nrate = 1e6\n")
        self.file("plain.bvh", STANDING)
        self.assertIn("rate from 10 to 1000", self.fail_with(
            1, "import", self.folder, "--manifest", manifest, "--out", self.folder / "out", **limits))
        slow = self.file("slow.bvh", take(3000, lambda time_s: 0).replace(
            "Frame Time: 0.0333333", "Frame Time: 9.9"))
        self.assertIn("more than 1000000 frames", self.fail_with(
            1, "import", slow, "--out", self.folder / "out", **limits))

    def test_what_is_odd_is_told_with_the_option_that_mends_it(self):
        out = self.folder / "out"
        slow = self.file("slow.bvh", STANDING.replace("Frame Time: 0.0333333", "Frame Time: 1"))
        note = "a frame lasts 1 s, which is 1 Hz; say the right rate with --rate-of-file"
        self.assertEqual(self.document("info", slow)["warnings"], [note])
        self.assertIn(f"note: {note}\n", self.succeed("info", slow).stdout)
        self.assertIn(f"note: {slow}: {note}\n", self.succeed("import", slow, "--out", out).stderr)
        self.assertEqual(self.document("info", slow, "--rate-of-file", 30)["warnings"], [])

        first_row = "0 90 0 0 0 0 "
        far = self.file("far.bvh", STANDING.replace(first_row, "500 90 0 0 0 0 ", 1))
        note = ("frame 1 is 5.00 m from frame 2; leave out what is not recorded with --skip-first")
        self.assertEqual(self.document("info", far)["warnings"], [note])
        made = self.document("import", far, "--out", out)
        self.assertEqual([clip["warnings"] for clip in made["clips"]], [[note]])
        for options in ([], ["--verbose"]):
            done = self.succeed("import", far, "--out", out, *options)
            self.assertEqual((done.stdout + done.stderr).count(note), 1)
            self.assertIn(f"note: {far.name}: clip far: {note}\n", done.stderr)
        self.assertEqual(self.document("info", far, "--skip-first")["warnings"], [])

    def test_a_clip_that_goes_too_far_names_the_frames_to_keep(self):
        rows = STANDING.splitlines(keepends=True)
        rows[-20] = rows[-20].replace("0 90 0 ", "300000 90 0 ", 1)
        path = self.file("far.bvh", "".join(rows))
        out = self.folder / "out"
        line = self.fail_with(1, "import", path, "--out", out)
        self.assertIn(f"{path}: the clip \"far\" goes farther than 1 km", line)
        self.assertIn("--frames 1:40, or frames in a manifest", line)
        self.succeed("import", path, "--out", out, "--frames", "1:40")

    def test_a_figure_of_no_human_size_names_the_option(self):
        path = self.file("tiny.bvh", STANDING)
        out = self.folder / "out"
        line = self.fail_with(1, "import", path, "--out", out, "--unit", "mm", "--frames", "1:2")
        self.assertIn(f"{path}: the skeleton is not between 0.2 m and 20 m tall; say the unit with "
                      "--unit", line)

    def test_source_tables_that_are_for_no_file_are_told(self):
        self.file("a.bvh", STANDING)
        idle = '[[idle]]\nname = "a"\nfile = "a.bvh"\n'
        out = self.folder / "out"
        for path, is_used in (("a.bvh", True), ("A.bvh", False), ("./a.bvh", False)):
            manifest = self.file("m.toml", f'{idle}[source."{path}"]\nskip_first = true\n')
            made = self.document("import", self.folder, "--manifest", manifest, "--out", out)
            note = (f'{manifest}:4: [source."{path}"] is for none of the manifest\'s files; '
                    "write its path as they do")
            self.assertEqual(made["warnings"], [] if is_used else [note])

    def test_angles_in_radians_are_told(self):
        head, rows = STANDING.split("Frame Time: 0.0333333\n")
        radians = [row.split()[:3] + [str(float(angle) / 57.29578) for angle in row.split()[3:]]
                   for row in rows.splitlines()]
        path = self.file("radians.bvh", head + "Frame Time: 0.0333333\n"
                         + "".join(" ".join(row) + "\n" for row in radians))
        note = "no rotation is beyond 2, and the figure moves like a human if they are radians"
        self.assertIn(note, self.succeed("info", path).stdout)
        self.assertIn(note, self.succeed("import", path, "--out", self.folder / "out").stderr)

    def test_any_bytes_in_names_give_valid_json_and_printable_text(self):
        text = STANDING.encode().replace(b"RightHand", b"Rechte\xe4Hand\x1b")
        strange = self.folder / "stran\udce4ge"
        strange.mkdir()
        path = strange / "take.bvh"
        path.write_bytes(text.replace(b"LeftHand", b"LeftHand\xff"))
        plain = self.file("plain.bvh", text)
        for command in (["info", plain], ["import", plain, "--out", self.folder / "out"],
                        ["annotate", plain, "--out", self.folder / "draft.toml"],
                        ["info", path], ["import", strange, "--out", strange / "out"]):
            with self.subTest(command=command[:1]):
                done = run(*command, "--json", encoding="utf-8", errors="strict")
                self.assertEqual(done.returncode, 0, done.stderr)
                document = json.loads(done.stdout)
                source = document.get("source") or document.get("sources", [document])[0]
                self.assertIn("Latin-1", " ".join(source["warnings"]))
        done = self.succeed("info", plain)
        self.assertIn("Rechte\u00e4Hand?", done.stdout)
        self.assertNotIn("\x1b", done.stdout)


if __name__ == "__main__":
    unittest.main()
