#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A store has the same bytes if one process or several simulated it, at once or in parts.

Tests that stop a run use the slow simulation, which takes long enough.
"""

import os
import pathlib
import shutil
import signal
import subprocess
import unittest

from flinch_program import FLINCH, StoreTest

SCENARIOS = 70
MPIRUN = shutil.which("mpirun")
EXAMPLES = pathlib.Path(os.environ["FLINCH_EXAMPLES"])


def wait_for_commit(process):
    """Waits for the first line of progress, which follows the first commit."""
    for line in process.stderr:
        if f"/{SCENARIOS} scenarios" in line:
            return
    raise AssertionError("it ended without any progress")


class RunTest(StoreTest):
    scenarios = SCENARIOS


class Alone(RunTest):
    """Runs of one process."""

    def test_threads_and_memory_do_not_show(self):
        whole = self.make_whole()
        store = self.folder / "little"
        done = self.succeed(*self.command(store, "--memory", "96M", "--threads", 2))
        self.assertIn("memory: at most 96 MiB; ", done.stderr)
        self.assertEqual(store.read_bytes(), whole)

    def test_too_little_memory_is_refused(self):
        line = self.fail_with(1, *self.command(self.folder / "x", "--memory", "20M",
                                               "--threads", 1))
        self.assertIn("give at least --memory 80M", line)
        self.fail_with(2, *self.command(self.folder / "x", "--memory", "much"))
        self.fail_with(2, *self.command(self.folder / "x", "--memory", "-1G"))

    def test_a_range_past_the_end_is_refused(self):
        line = self.fail_with(1, *self.command(self.folder / "x", "--first", 2**63 - 5))
        self.assertIn("past the last", line)
        self.fail_with(2, *self.command(self.folder / "x", "--first", "-3"))
        self.fail_with(2, *self.command(self.folder / "x", "--seed", "-1"))
        self.fail_with(2, *self.command(self.folder / "x", scenarios=0))

    def test_lines_for_machines(self):
        lines = self.lines(*self.command(self.folder / "store"))
        self.assertEqual({line["kind"] for line in lines[:-1]}, {"progress"})
        scenarios = [line["scenarios"] for line in lines]
        self.assertEqual(scenarios, sorted(scenarios))
        last = lines[-1]
        self.assertEqual((last["kind"], last["scenarios"], last["first"]), ("store", SCENARIOS, 0))
        self.assertGreater(last["hits"], 0.3 * last["simulations"])
        self.assertEqual(set(last["cpu_s"]), {"posing", "rehearsing", "striking", "writing"})
        self.assertGreater(sum(last["cpu_s"].values()), 0)

    def test_the_unabridged_simulation_is_another_run(self):
        whole = self.make_whole()
        line = self.fail_with(1, *self.command(self.folder / "whole", "--reference"))
        self.assertIn("another simulation", line)
        self.assertEqual((self.folder / "whole").read_bytes(), whole)
        self.succeed(*self.command(self.folder / "slow", "--reference", scenarios=2))


@unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "there is one processor")
class BoundProcesses(RunTest):
    """A launcher that leaves a run's threads too few processors."""

    def notes(self, *launcher, threads=2, bind=None):
        done = subprocess.run(
            [*launcher, FLINCH, *self.command(self.folder / "store", "--threads", threads)],
            capture_output=True, text=True, check=True, preexec_fn=bind)
        return [line for line in done.stderr.splitlines() if line.startswith("note: this process")]

    @staticmethod
    def bind_to_one():
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

    def test_are_told_of(self):
        processors = len(os.sched_getaffinity(0))
        (note,) = self.notes(bind=self.bind_to_one)
        self.assertIn(f"bound to 1 of {processors} processors, where 2 threads could run", note)
        self.assertEqual(self.notes(threads=1, bind=self.bind_to_one), [])
        self.assertEqual(self.notes(), [])
        self.assertEqual(self.notes(threads=processors + 1), [])

    @unittest.skipIf(MPIRUN is None, "there is no mpirun")
    def test_of_mpirun_are_told_of(self):
        mpirun = [MPIRUN, "--allow-run-as-root", "--oversubscribe", "-n", "1"]
        (note,) = self.notes(*mpirun)
        self.assertIn("give mpirun the option --bind-to none", note)
        self.assertEqual(self.notes(*mpirun, "--bind-to", "none"), [])


class ClusterExamples(RunTest):
    """The job scripts, without a cluster."""

    def test_are_sound(self):
        scripts = sorted(EXAMPLES.glob("*.sh"))
        self.assertEqual(len(scripts), 2)
        for script in scripts:
            subprocess.run(["bash", "-n", script], check=True)

    def test_the_array_makes_the_store_of_one_run(self):
        whole = self.make_whole()
        settings = {**os.environ, "FLINCH": FLINCH, "LIBRARY": str(self.library), "SEED": "1",
                    "STORE": str(self.folder / "joined"), "SCENARIOS": str(SCENARIOS),
                    "SLURM_CPUS_PER_TASK": "1", "MEMORY": "128M"}
        script = EXAMPLES / "slurm_array.sh"
        # 3 does not divide 70: the last task has fewer scenarios.
        for task in (2, 0, 1):
            subprocess.run(["bash", script], check=True, capture_output=True,
                           env={**settings, "SLURM_ARRAY_TASK_ID": str(task),
                                "SLURM_ARRAY_TASK_COUNT": "3"})
        subprocess.run(["bash", script, "merge"], check=True, capture_output=True, env=settings)
        self.assertEqual((self.folder / "joined").read_bytes(), whole)


@unittest.skipIf(MPIRUN is None, "there is no mpirun")
class Processes(RunTest):
    """Runs of several processes of an MPI job."""

    def mpirun(self, count, *command):
        return [MPIRUN, "--allow-run-as-root", "--oversubscribe", "-n", str(count), FLINCH,
                *command]

    def run_job(self, count, *command):
        return subprocess.run(self.mpirun(count, *command), capture_output=True, text=True,
                              check=False)

    def test_their_number_does_not_show(self):
        whole = self.make_whole()
        for count in (1, 2, 3):
            store = self.folder / f"processes-{count}"
            done = self.run_job(count, *self.command(store, "--threads", 1))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"{SCENARIOS} scenarios of synthetic", done.stdout)
            self.assertEqual(store.read_bytes(), whole)

    def test_a_killed_one_ends_the_job_and_loses_nothing(self):
        whole = self.make_whole("--reference")
        store = self.folder / "killed"
        command = self.command(store, "--threads", 1, "--reference")
        job = subprocess.Popen(self.mpirun(3, *command), stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        wait_for_commit(job)
        victim = max(self.children(job.pid))
        os.kill(victim, signal.SIGKILL)
        _, errors = job.communicate()
        self.assertNotEqual(job.returncode, 0)
        self.assertIn("signal 9", errors)
        self.assertFalse(store.exists())
        done = self.run_job(2, *command)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("continuing after", done.stderr)
        self.assertEqual(store.read_bytes(), whole)

    def test_what_is_wrong_is_told_once(self):
        done = self.run_job(3, "simulate", self.folder / "missing", "--out", self.folder / "x",
                            "-n", "5")
        self.assertEqual(done.returncode, 1)
        told = [line for line in done.stderr.splitlines() if line.startswith("flinch: ")]
        self.assertEqual(len(told), 1, done.stderr)
        self.assertIn("missing", told[0])

    @staticmethod
    def children(pid):
        """Returns the ids of the job's flinch processes."""
        found = []
        for status in pathlib.Path("/proc").glob("[0-9]*/status"):
            try:
                fields = dict(line.split(":", 1) for line in status.read_text().splitlines()
                              if ":" in line)
            except OSError:
                continue
            if int(fields["PPid"]) == pid and fields["Name"].strip() == "flinch":
                found.append(int(fields["Pid"]))
        return found


if __name__ == "__main__":
    unittest.main()
