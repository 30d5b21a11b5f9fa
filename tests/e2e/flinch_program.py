# SPDX-License-Identifier: MIT
"""Runs the program for the end-to-end tests. Environment variables give its path."""

import functools
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

try:
    import jsonschema
except ImportError:  # then e2e.schemas is skipped, and says so
    jsonschema = None

FLINCH = os.environ["FLINCH"]
SCHEMA = pathlib.Path(__file__).resolve().parents[2] / "docs/schemas/flinch.schema.json"
MOCAP = pathlib.Path(os.environ["FLINCH_MOCAP_DIR"])


def run(*arguments, **options):
    """Runs the program and returns the finished process with its output."""
    return subprocess.run([FLINCH, *map(str, arguments)], capture_output=True, text=True,
                          check=False, **options)


@functools.cache
def validator_of(command):
    """Of the documents that a command prints."""
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    return jsonschema.Draft202012Validator({**schema, "$ref": f"#/$defs/{command}"})


def checked(command, text):
    """Returns the document in `text`, which must be as docs/schemas says."""
    document = json.loads(text)
    if jsonschema is not None:
        validator_of(command).validate(document)
    return document


def make_library(path, name="synthetic"):
    subprocess.run([os.environ["FLINCH_MAKE_LIBRARY"], str(path), name], check=True)


@functools.cache
def shared_folder():
    """A folder for what several tests of a file read, which goes when they are done."""
    folder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(folder.cleanup)
    return pathlib.Path(folder.name)


class ProgramTest(unittest.TestCase):
    """A test with a separate folder for each case."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def succeed(self, *arguments, **options):
        done = run(*arguments, **options)
        self.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr}")
        return done

    def document(self, *arguments):
        """Returns the one document that --json prints."""
        done = self.succeed(*arguments, "--json")
        self.assertEqual(done.stderr, "")
        return checked(arguments[0], done.stdout)

    def lines(self, *arguments):
        """Returns what `simulate --json` prints: one document per line, the summary last."""
        done = self.succeed(*arguments, "--json")
        self.assertEqual(done.stderr, "")
        return [checked(arguments[0], line) for line in done.stdout.splitlines()]

    def fail_with(self, code, *arguments, **options):
        """Expects that the command fails, and returns its one line on stderr."""
        done = run(*arguments, **options)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stdout}{done.stderr}")
        self.assertEqual(done.stdout, "", arguments)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, f"{arguments}: {done.stderr}")
        self.assertTrue(lines[0].startswith("flinch: "), lines[0])
        return lines[0]


class StoreTest(ProgramTest):
    """A test with a library, and stores of its first `scenarios` to compare with."""
    scenarios = 0

    def setUp(self):
        super().setUp()
        self.library = shared_folder() / "a.flinchlib"
        if not self.library.exists():
            make_library(self.library)
        self.whole = self.folder / "whole"

    def command(self, store, *options, scenarios=None):
        return [str(part) for part in ("simulate", self.library, "--out", store, "-n",
                                       self.scenarios if scenarios is None else scenarios,
                                       *options)]

    def make_whole(self, *options):
        """Writes `whole`, a store of one thread; returns its bytes. Simulated once per file."""
        made = shared_folder() / " ".join(("whole", *options))
        if not made.exists():
            self.succeed(*self.command(made, "--threads", 1, *options))
        shutil.copy(made, self.whole)
        return self.whole.read_bytes()
