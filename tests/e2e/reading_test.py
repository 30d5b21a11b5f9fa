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
                self.assertIn(f"note: {document['warnings'][0]}\n", done.stdout)

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
