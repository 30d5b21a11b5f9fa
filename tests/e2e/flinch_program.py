# SPDX-License-Identifier: MIT
"""Runs the program for the end-to-end tests, which set its path by environment variables."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

FLINCH = os.environ["FLINCH"]
MOCAP = pathlib.Path(os.environ["FLINCH_MOCAP_DIR"])


def run(*arguments, **options):
    """The finished process with its text."""
    return subprocess.run([FLINCH, *map(str, arguments)], capture_output=True, text=True,
                          check=False, **options)


def make_library(path, name="synthetic"):
    subprocess.run([os.environ["FLINCH_MAKE_LIBRARY"], str(path), name], check=True)


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own for each case."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def succeed(self, *arguments, **options):
        done = run(*arguments, **options)
        self.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr}")
        return done

    def document(self, *arguments):
        """What --json prints, which is one document and nothing else."""
        done = self.succeed(*arguments, "--json")
        self.assertEqual(done.stderr, "")
        return json.loads(done.stdout)

    def lines(self, *arguments):
        """What `simulate --json` prints: a document a line, the last one its summary."""
        done = self.succeed(*arguments, "--json")
        self.assertEqual(done.stderr, "")
        return [json.loads(line) for line in done.stdout.splitlines()]

    def fail_with(self, code, *arguments, **options):
        """The one line on stderr of a command that fails."""
        done = run(*arguments, **options)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stdout}{done.stderr}")
        self.assertEqual(done.stdout, "", arguments)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, f"{arguments}: {done.stderr}")
        self.assertTrue(lines[0].startswith("flinch: "), lines[0])
        return lines[0]
