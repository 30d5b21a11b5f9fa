#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a command writes never destroys what it reads, nor what it did not make itself."""

import os
import re
import resource
import shutil
import stat
import subprocess
import unittest

from flinch_program import FLINCH, ProgramTest, make_library, run, shared_folder

CHARACTER = 'height_m = 1.8\nmass_kg = 80\nsex = "male"\n'


def inputs():
    """A folder with one input of each kind, made once."""
    folder = shared_folder() / "inputs"
    if not folder.exists():
        folder.mkdir()
        make_library(folder / "a.flinchlib")
        for arguments in (["simulate", "a.flinchlib", "--out", "a.flinchobs", "-n", 12],
                          ["train", "a.flinchobs", "--out", "a.flinch"],
                          ["respond", "a.flinch", "--out", "a.bvh"]):
            done = run(*arguments, cwd=folder)
            assert done.returncode == 0, done.stderr
        (folder / "a.toml").write_text(CHARACTER)
    return folder


class Output(ProgramTest):
    def setUp(self):
        super().setUp()
        for path in inputs().iterdir():
            shutil.copy(path, self.folder)
        self.cwd = {"cwd": self.folder}

    # Each command that writes a file, without its --out; its input; an output's name.
    writers = {
        "author": (["author", "--character", "a.toml"], "a.toml", "out.flinchlib"),
        "import": (["import", "a.bvh"], "a.bvh", "imported.flinchlib"),
        "simulate": (["simulate", "a.flinchlib", "-n", 2], "a.flinchlib", "out.flinchobs"),
        "merge": (["merge", "a.flinchobs"], "a.flinchobs", "merged.flinchobs"),
        "train": (["train", "a.flinchobs"], "a.flinchobs", "out.flinch"),
        "export to csv": (["export", "a.flinchobs"], "a.flinchobs", "out.csv"),
        "export to libsvm": (["export", "a.flinchobs"], "a.flinchobs", "out.libsvm"),
        "respond as glb": (["respond", "a.flinch"], "a.flinch", "out.glb"),
        "respond as bvh": (["respond", "a.flinch"], "a.flinch", "out.bvh"),
        "respond as svg": (["respond", "a.flinch"], "a.flinch", "out.svg"),
    }

    def content(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}

    def refuse(self, words, *arguments):
        before = self.content()
        line = self.fail_with(1, *arguments, **self.cwd)
        self.assertRegex(line, words)
        self.assertEqual(self.content(), before, arguments)

    def test_an_output_that_is_an_input_is_refused_even_if_forced(self):
        for name, (command, source, out) in self.writers.items():
            link = self.folder / f"link{os.path.splitext(out)[1]}"
            for make in (link.symlink_to, link.hardlink_to):
                make(self.folder / source)
                with self.subTest(name):
                    self.refuse("an input of this command", *command, "--out", link.name, "--force")
                link.unlink()

    def test_files_of_another_kind_are_replaced_only_if_forced(self):
        for name, (command, _, out) in self.writers.items():
            with self.subTest(name):
                path = self.folder / out
                path.write_text("Dear Sir,\n")
                self.refuse("--force", *command, "--out", out)
                self.succeed(*command, "--out", out, "--force", **self.cwd)
                first = path.read_bytes()
                self.assertNotIn(b"Dear Sir", first)
                # What it has written itself, a command replaces unasked.
                self.succeed(*command, "--out", out, **self.cwd)
                self.assertEqual(path.read_bytes(), first)
                path.unlink()
        self.assertEqual(sorted(self.content()), sorted(p.name for p in inputs().iterdir()))

    def test_motion_of_others_is_not_replaced(self):
        other = self.folder / "walk.bvh"
        other.write_text((self.folder / "a.bvh").read_text().replace("ROOT pelvis", "ROOT Hips"))
        self.refuse("not made by this command", "respond", "a.flinch", "--out", "walk.bvh")
        manifest = self.folder / "m.toml"
        manifest.write_text('[[idle]]\nname = "i"\nfile = "walk.bvh"\n')
        self.refuse("an input", "import", self.folder, "--manifest", "m.toml", "--out", "walk.bvh",
                    "--force")
        self.refuse("an input", "import", ".", "--out", "walk.bvh", "--force")
        self.refuse("an input", "import", "a.bvh", "--manifest", "m.toml", "--out", "m.toml",
                    "--force")

    def test_only_regular_files_are_replaced(self):
        os.mkfifo(self.folder / "pipe")
        for name, (command, _, out) in self.writers.items():
            if not name.startswith(("export", "respond")):  # those want an ending
                with self.subTest(name):
                    self.refuse("device, pipe or socket", *command, "--out", "pipe", "--force")
                    self.refuse("device, pipe or socket", *command, "--out", "/dev/null", "--force")
            (self.folder / f"folder-{out}").mkdir()
            self.refuse("is a folder", *command, "--out", f"folder-{out}", "--force")
        self.assertTrue(stat.S_ISFIFO((self.folder / "pipe").stat().st_mode))

    def test_links_and_permissions_of_outputs_stay(self):
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        for name, (command, _, out) in self.writers.items():
            with self.subTest(name):
                (self.folder / out).symlink_to(elsewhere / out)
                self.succeed(*command, "--out", out, **self.cwd)
                (elsewhere / out).chmod(0o640)
                self.succeed(*command, "--out", out, **self.cwd)
                self.assertTrue((self.folder / out).is_symlink())
                self.assertTrue((elsewhere / out).is_file())
                self.assertEqual(stat.S_IMODE((elsewhere / out).stat().st_mode), 0o640)

    def test_partial_files_are_not_written_through_links(self):
        precious = self.folder / "precious"
        precious.write_text("")
        for name, (command, _, out) in self.writers.items():
            with self.subTest(name):
                (self.folder / f"{out}.partial").symlink_to(precious)
                self.refuse("in the way", *command, "--out", out, "--force")

    def test_an_unfinished_store_is_not_taken_for_a_left_over(self):
        shutil.copy(self.folder / "a.flinchobs", self.folder / "b.partial")
        self.refuse("b.partial: is a store", "author", "--out", "b")

    def test_reports_are_checked_before_the_run(self):
        (self.folder / "file").write_text("")
        self.refuse("file: is a file; name a folder", "compare", "missing", "--report", "file")
        (self.folder / "report").mkdir()
        shutil.copy(self.folder / "a.flinchobs", self.folder / "report/scenarios.csv")
        self.refuse("an input", "compare", "report/scenarios.csv", "--report", "report", "--force")
        self.refuse("--force", "compare", "missing", "--report", "report")

    def test_galleries_keep_the_readme_of_others(self):
        (self.folder / "README.md").write_text("# Mine\n")
        self.refuse("README.md: .* --force", "author", "--out", "out", "--gallery", ".")
        self.succeed("author", "--out", "out", "--gallery", "gallery", **self.cwd)
        self.succeed("author", "--out", "out", "--gallery", "gallery", **self.cwd)

    def test_drafts_are_kept_unless_forced(self):
        for path in ("a.toml", "sheet.svg"):
            (self.folder / path).write_text("corrected by hand")
        self.refuse("corrections; give --force", "annotate", "a.bvh", "--sheet", "new.svg")
        self.refuse("corrections; give --force", "annotate", "a.bvh", "--out", "new.toml",
                    "--sheet", "sheet.svg")
        self.refuse("an input", "annotate", "a.bvh", "--out", "a.bvh", "--force")
        self.refuse("two outputs", "annotate", "a.bvh", "--out", "new", "--sheet", "./new")

    def test_names_that_sqlite_takes_for_other_things_are_files(self):
        for name in (":memory:", "file:a?mode=memory"):
            self.succeed("simulate", "a.flinchlib", "--out", name, "-n", 2, **self.cwd)
            self.assertTrue((self.folder / name).is_file())
            self.succeed("info", name, **self.cwd)

    def test_text_that_cannot_be_printed_is_an_error(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments in (["--help"], ["train", "--help"], ["--version"], ["info", "a.flinchlib"],
                              ["info", "a.flinchlib", "--json"], ["select", "a.flinch"]):
                done = subprocess.run([FLINCH, *arguments], stdout=full, stderr=subprocess.PIPE,
                                      text=True, check=False, **self.cwd)
                self.assertEqual((done.returncode, done.stderr),
                                 (1, "flinch: cannot write to standard output\n"), arguments)

    def test_closed_streams_do_not_end_up_in_files(self):
        whole = self.folder / "whole"
        self.succeed("simulate", "a.flinchlib", "--out", whole, "-n", 2, **self.cwd)
        subprocess.run('"$FLINCH" simulate a.flinchlib --out part -n 2 <&- >&- 2>&-', shell=True,
                       check=False, **self.cwd)
        self.assertEqual((self.folder / "part").read_bytes(), whole.read_bytes())
        done = subprocess.run('"$FLINCH" train a.flinchobs --out closed >&-', shell=True, check=False,
                              capture_output=True, text=True, **self.cwd)
        self.assertEqual((done.returncode, done.stderr.splitlines()[-1]),
                         (1, "flinch: cannot write to standard output"))

    def test_a_limit_on_file_size_is_told(self):
        for command, out in ((["train", "a.flinchobs"], "a.flinch"),
                             (["simulate", "a.flinchlib", "-n", 20], "b.flinchobs")):
            before = self.content()
            done = subprocess.run(
                [FLINCH, *map(str, command), "--out", out], stderr=subprocess.PIPE, text=True,
                check=False, **self.cwd,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (30000, 30000)))
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertRegex(done.stderr.splitlines()[-1], "^flinch: .*limit")
            after = {name: data for name, data in self.content().items()
                     if not name.startswith("b.flinchobs.partial")}
            self.assertEqual(after, before)

    def test_numbers_are_refused_and_not_converted(self):
        for option in ("--seed", "--first", "--memory", "-n", "--threads"):
            for number in ("-1", "+1", "-18446744073709551615", "1e30", "0x10", "", "nan",
                           "99999999999999999999999"):
                arguments = ["simulate", "a.flinchlib", "--out", "out", "-n", "2", option, number]
                if option == "-n":
                    arguments[4:6] = []
                with self.subTest(f"{option} {number!r}"):
                    self.assertIn(option, self.fail_with(2, *arguments, **self.cwd))
        self.refuse("past the last number", "simulate", "a.flinchlib", "--out", "out", "-n", 2, "--first", 2**64 - 1)
        for memory in ("-1M", "1X", "99999999999G", "M"):
            self.assertIn("--memory", self.fail_with(2, "simulate", "a.flinchlib", "--out", "out",
                                                     "-n", 2, "--memory", memory, **self.cwd))

    def test_control_characters_in_names_are_printed_escaped(self):
        raw = re.compile("[\x00-\x09\x0b-\x1f\x7f\u0080-\u009f]")
        name = "a\x1b[2Jb\rc\x7f\u009bd\xe9\n.bvh"
        shutil.copy(self.folder / "a.bvh", self.folder / name)
        bvh = (self.folder / "a.bvh").read_text().replace("JOINT abdomen", "JOINT abdo\x1bmen")
        (self.folder / "joint.bvh").write_text(bvh)
        (self.folder / "roles.toml").write_text('[roles]\nhead = "no\\u001bne"\n')
        escaped = "a\\x1b[2Jb\\rc\\x7f\\xc2\\x9bd\xe9\\n.bvh"
        for arguments, code in ((["info", name], 0), (["info", f"{name}x"], 1),
                                (["import", name, "--out", "out\x1b.flinchlib", "--verbose"], 0),
                                (["info", "missing\x1b.flinchlib"], 1),
                                (["train", "out\x1b.flinchlib", "--out", "x"], 1),
                                (["info", "joint.bvh"], 0),
                                (["info", "a.bvh", "--roles", "roles.toml"], 1),
                                (["train", "a.flinchobs", "--out", "x", "--model", "k\x1bnn"], 2)):
            done = run(*arguments, **self.cwd)
            text = done.stdout + done.stderr
            self.assertEqual(done.returncode, code, text)
            self.assertIsNone(raw.search(text), repr(text))
            # Readers replace them in what they keep; messages escape what they repeat.
            self.assertTrue(escaped in text or "\\x1b" in text or "abdo?men" in text, text)


if __name__ == "__main__":
    unittest.main()
