#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A store is never lost and never incomplete, whatever happens to the program."""

import resource
import signal
import sqlite3
import subprocess
import unittest

from flinch_program import FLINCH, StoreTest, make_library
from store_costs import trials_of

SCENARIOS = 40
SLOW = "--reference"  # makes a run slow enough to be stopped midway


class Store(StoreTest):
    scenarios = SCENARIOS

    def stop_midway(self, store, how):
        """Signals a run after its first commit; returns its exit code and line on stderr."""
        process = subprocess.Popen([FLINCH, *self.command(store, "--threads", 1, SLOW)],
                                   stderr=subprocess.PIPE, text=True)
        self.wait_for_commit(process)
        process.send_signal(how)
        rest = process.stderr.read()
        process.stderr.close()
        return process.wait(), rest.splitlines()[-1] if rest else ""

    def wait_for_commit(self, process):
        """Waits for the first line of progress, which follows the first commit."""
        for line in process.stderr:
            if f"/{SCENARIOS} scenarios" in line:
                return
        self.fail("it ended without any progress")

    def test_the_number_of_threads_does_not_show(self):
        whole = self.make_whole()
        for threads in (2, 3):
            store = self.folder / f"threads-{threads}"
            self.succeed(*self.command(store, "--threads", threads))
            self.assertEqual(store.read_bytes(), whole)

    def test_after_ctrl_c_the_same_command_goes_on(self):
        whole = self.make_whole(SLOW)
        store = self.folder / "interrupted"
        code, line = self.stop_midway(store, signal.SIGINT)
        self.assertEqual(code, 1)
        self.assertRegex(line, r"^flinch: .*interrupted; \d+ of 40 scenarios are kept, run the "
                               r"same command again")
        self.assertFalse(store.exists())
        done = self.succeed(*self.command(store, SLOW))
        self.assertIn("continuing after", done.stderr)
        self.assertEqual(store.read_bytes(), whole)

    def test_after_a_kill_the_same_command_goes_on(self):
        whole = self.make_whole(SLOW)
        store = self.folder / "killed"
        code, _ = self.stop_midway(store, signal.SIGKILL)
        self.assertEqual(code, -signal.SIGKILL)
        self.assertFalse(store.exists())
        self.succeed(*self.command(store, SLOW))
        self.assertEqual(store.read_bytes(), whole)
        self.assertEqual(list(self.folder.glob("killed?*")), [])

    def test_more_scenarios_continue_a_finished_store(self):
        whole = self.make_whole()
        store = self.folder / "grown"
        self.succeed(*self.command(store, scenarios=21))
        self.succeed(*self.command(store))
        self.assertEqual(store.read_bytes(), whole)
        done = self.lines(*self.command(store, scenarios=5))[-1]
        self.assertEqual(done["scenarios"], SCENARIOS)
        self.assertEqual(store.read_bytes(), whole)

    def test_a_store_of_another_run_is_refused(self):
        whole = self.make_whole()
        other = self.folder / "other.flinchlib"
        make_library(other, "other")
        line = self.fail_with(1, "simulate", other, "--out", self.whole, "-n", 50)
        self.assertIn("another library (synthetic", line)
        line = self.fail_with(1, *self.command(self.whole, "--seed", 2, scenarios=50))
        self.assertIn("--seed 1", line)
        self.assertEqual(self.whole.read_bytes(), whole)

    def test_two_writers_do_not_mix(self):
        store = self.folder / "shared"
        first = subprocess.Popen([FLINCH, *self.command(store, "--threads", 1, SLOW)],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.wait_for_commit(first)
        line = self.fail_with(1, *self.command(store, SLOW))
        self.assertIn("another process", line)
        first.stderr.read()
        first.stderr.close()
        self.assertEqual(first.wait(), 0)
        self.assertEqual(store.read_bytes(), self.make_whole(SLOW))

    def run_with_little_room(self, room, *arguments):
        """Returns the finished process, whose files could not grow beyond `room` bytes."""
        def allow_little():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (room, resource.RLIM_INFINITY))

        return subprocess.run([FLINCH, *map(str, arguments)], stderr=subprocess.PIPE,
                              stdout=subprocess.PIPE, text=True, check=False,
                              preexec_fn=allow_little, restore_signals=False)

    def test_a_full_disk_is_told_and_loses_nothing(self):
        self.make_whole()
        room = self.whole.stat().st_size  # size of a store of fewer scenarios
        many = 3 * SCENARIOS
        whole = self.folder / "many"
        self.succeed(*self.command(whole, scenarios=many))
        store = self.folder / "full"
        process = self.run_with_little_room(room, *self.command(store, "--threads", 1, scenarios=many))
        self.assertEqual(process.returncode, 1, process.stderr)
        self.assertIn("make room", process.stderr.splitlines()[-1])
        self.assertFalse(store.exists())
        done = self.succeed(*self.command(store, scenarios=many))
        self.assertIn("continuing after", done.stderr)
        self.assertEqual(store.read_bytes(), whole.read_bytes())

    def test_merged_stores_are_the_store_of_all(self):
        whole = self.make_whole()
        part = self.folder / "part"
        merged = self.folder / "merged"
        self.succeed("simulate", self.library, "--out", part, "-n", 21)
        process = self.run_with_little_room(len(whole) // 2, "merge", self.whole, part, "--out", merged)
        self.assertEqual(process.returncode, 1)
        self.assertIn("make room", process.stderr)
        self.assertFalse(merged.exists())
        document = self.document("merge", self.whole, part, "--out", merged)
        self.assertEqual((document["first"], document["scenarios"]), (0, SCENARIOS))
        self.assertEqual(merged.read_bytes(), whole)
        self.assertEqual(list(self.folder.glob("merged?*")), [])

    def test_stores_of_other_runs_are_not_merged(self):
        self.make_whole()
        stores = {"--seed 2, not 1": self.folder / "seed", "another library": self.folder / "library"}
        other = self.folder / "other.flinchlib"
        make_library(other, "other")
        self.succeed("simulate", self.library, "--out", stores["--seed 2, not 1"], "-n", 2, "--seed", 2)
        self.succeed("simulate", other, "--out", stores["another library"], "-n", 2)
        for words, store in stores.items():
            line = self.fail_with(1, "merge", self.whole, store, "--out", self.folder / "merged")
            self.assertIn(f"{store}: made", line)
            self.assertIn(words, line)
            self.assertEqual(list(self.folder.glob("merged*")), [])

    def test_info_tells_what_a_store_holds(self):
        size = len(self.make_whole())
        document = self.document("info", self.whole)
        self.assertEqual((document["first"], document["scenarios"]), (0, SCENARIOS))
        with sqlite3.connect(f"file:{self.whole}?mode=ro", uri=True) as database:
            trials = [t for (blob,) in database.execute("SELECT trials FROM observation")
                      for t in trials_of(blob)]
            library = database.execute("SELECT length(file) FROM library").fetchone()[0]
        self.assertEqual(document["trials"], len(trials))
        hits = sum(len(impulse) for _, _, impulse in trials)
        self.assertAlmostEqual(document["non_zero_impulse_share"], hits / (17 * len(trials)))
        self.assertGreater(hits, SCENARIOS / 2)
        self.assertEqual(document["bytes"], size)
        self.assertAlmostEqual(document["bytes_per_scenario"], (size - library) / SCENARIOS)


if __name__ == "__main__":
    unittest.main()
