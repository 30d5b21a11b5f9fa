# SPDX-License-Identifier: MIT
"""The offline part in Python does what the program does. Environment: FLINCH (the program), BVH
(a folder of motion)."""

import csv
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import unittest

import numpy

import flinch

FLINCH = os.environ["FLINCH"]
SCENARIOS = 60


def run(*arguments):
    return subprocess.run([FLINCH, *map(str, arguments)], capture_output=True, text=True, check=False)


class Offline(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.library = cls.folder / "a.flinchlib"
        cls.succeed("author", "--out", cls.library)
        cls.file = cls.folder / "a.flinchobs"
        cls.succeed("simulate", cls.library, "--out", cls.file, "-n", SCENARIOS)
        cls.store = flinch.Store(cls.file)

    @staticmethod
    def succeed(*arguments):
        done = run(*arguments)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def path(self, name):
        return self.folder / f"{self.id().rpartition('.')[2]}.{name}"

    def test_authors_the_same_file(self):
        told = []
        library = flinch.author(progress=lambda *news: told.append(news))
        library.save(self.path("flinchlib"))
        self.assertEqual(self.path("flinchlib").read_bytes(), self.library.read_bytes())
        self.assertEqual(told, [("authoring clips", 0, 0)])
        read = flinch.ClipLibrary(self.library)
        self.assertEqual(read.hash, library.hash)
        root, rotation = read.poses(read.idle)
        self.assertEqual(rotation.shape, (len(root), 21, 4))
        numpy.testing.assert_allclose(numpy.linalg.norm(rotation, axis=2), 1, atol=1e-5)
        clip = read.clips[read.idle]
        self.assertAlmostEqual(clip["duration_s"], (len(root) - 1) / read.rate_hz, places=5)
        self.assertEqual(clip["purpose"], "idle")

    def test_imports_the_same_file(self):
        bvh = os.environ["BVH"]
        library, notes = flinch.import_motion([bvh], rate_hz=30)
        library.save(self.path("flinchlib"))
        document = json.loads(self.succeed("import", bvh, "--rate", 30, "--out",
                                           self.path("program.flinchlib"), "--json"))
        self.assertEqual(library.hash, document["hash"])
        self.assertEqual(len(library.clips), document["clip_count"])
        told = document["warnings"] + [w for s in document["sources"] for w in s["warnings"]]
        self.assertTrue(all(any(w in note for note in notes) for w in told))
        with self.assertRaisesRegex(ValueError, "there is no unit parsec"):
            flinch.import_motion([bvh], unit="parsec")

    def test_simulates_the_same_bytes_and_tells_progress(self):
        told = []
        counts = flinch.simulate(self.library, self.path("flinchobs"), 12, seed=7, threads=1,
                                 progress=lambda *news: told.append(news))
        self.succeed("simulate", self.library, "--out", self.path("program"), "-n", 12, "--seed", 7)
        self.assertEqual(self.path("flinchobs").read_bytes(), self.path("program").read_bytes())
        self.assertEqual(told[-1], ("simulating scenarios", 12, 12))
        self.assertGreater(counts["hits"], 0)
        with self.assertRaises(flinch.Error) as caught:
            flinch.simulate(self.library, self.library, 12)
        self.assertIsNone(caught.exception.status)
        self.assertEqual(f"flinch: {caught.exception}\n",
                         run("simulate", self.library, "--out", self.library, "-n", 12).stderr)

    def test_ctrl_c_keeps_what_is_finished(self):
        # Ctrl-C from another thread, once something is finished.
        timers = []

        def press(*_):
            if not timers:
                timers.append(threading.Timer(0.05, lambda: os.kill(os.getpid(), signal.SIGINT)))
                timers[0].start()
        with self.assertRaises(KeyboardInterrupt):
            flinch.simulate(self.library, self.path("flinchobs"), 100000, threads=1, progress=press)
        timers[0].join()
        self.assertTrue(self.path("flinchobs.partial").exists())
        self.assertEqual(flinch.author().name, flinch.ClipLibrary(self.library).name)  # goes on

    def test_an_error_in_progress_ends_the_work(self):
        def fail(*_):
            raise ZeroDivisionError("mine")
        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            flinch.compare(self.file, models=["knn"], progress=fail)

    def test_arrays_are_those_of_the_exported_table(self):
        self.succeed("export", self.file, "--out", self.path("csv"), "--brawn", 0.3)
        with open(self.path("csv"), encoding="utf-8") as file:
            table = list(csv.DictReader(file))
        label, cost = self.store.label(brawn=0.3)
        self.assertEqual(len(table), len(self.store))
        names = list(table[0])
        first_cost = names.index("idle_cost_ns") + 1
        self.assertEqual(names[2:2 + len(self.store.feature_names)], self.store.feature_names)
        for i, row in enumerate(table):
            self.assertEqual(int(row["number"]), self.store.number[i])
            self.assertEqual(row["target"], flinch.TARGETS[self.store.target[i]])
            self.assertEqual(int(row["label"]), label[i])
            self.assertEqual(row["clip"], self.store.clips[label[i]])
            self.assertEqual([float(row[name]) for name in self.store.feature_names],
                             [float(value) for value in self.store.features[i]])
            told = [float(row[name] or "nan") for name in names[first_cost:]]
            numpy.testing.assert_array_equal(told, cost[i])
        numpy.testing.assert_array_equal(numpy.isnan(cost), numpy.isnan(self.store.work_j))
        self.assertFalse(self.store.features.flags.writeable)

    def test_the_cost_is_its_formula(self):
        brawn = 0.25
        cost_model = json.loads(self.succeed("compare", self.file, "--models", "knn", "--brawn", brawn,
                                             "--json"))["cost_model"]
        vulnerability = [cost_model["vulnerability"][body] for body in flinch.BODIES]
        damage = self.store.impulse_ns @ numpy.array(vulnerability)
        scale = cost_model["reference_damage_ns"][0] / cost_model["reference_work_j"]
        _, cost = self.store.label(brawn)
        numpy.testing.assert_allclose(cost, (1 - brawn) * damage + brawn * self.store.work_j * scale,
                                      rtol=1e-6)

    def test_frames_are_the_arrays(self):
        try:
            from flinch import frames
        except ImportError:
            self.skipTest("pandas is missing")
        scenarios = frames.scenarios(self.store, brawn=0.3)
        self.succeed("export", self.file, "--out", self.path("csv"), "--brawn", 0.3)
        import pandas
        told = pandas.read_csv(self.path("csv"), float_precision="round_trip")[scenarios.columns]
        pandas.testing.assert_frame_equal(scenarios, told, check_dtype=False, check_exact=True)
        trials = frames.trials(self.store)
        self.assertEqual(len(trials), numpy.count_nonzero(~numpy.isnan(self.store.work_j)))
        least = trials.groupby("number")["cost_ns"].min()
        label, cost = self.store.label()
        best = cost[numpy.arange(len(label)), label]
        self.assertTrue((best <= least.loc[self.store.number].to_numpy() * 1.01).all())

    def test_fits_the_same_file_and_chooses_by_it(self):
        for model, options, arguments in (
                ("knn", {"k": 5}, ["-k", 5]),
                ("svm", {"c": 10, "libsvm_defaults": True}, ["--c", 10, "--parameters", "libsvm"])):
            selector = flinch.fit(self.store, model, brawn=0.1, seed=3, **options)
            selector.save(self.path("flinch"))
            document = json.loads(self.succeed("train", self.file, "--out", self.path("program"), "--model",
                                               model, "--brawn", 0.1, "--seed", 3, *arguments, "--json"))
            self.assertEqual(self.path("flinch").read_bytes(), self.path("program").read_bytes())
            self.assertEqual(selector.parameters, document["parameters"])
            self.assertEqual(selector.cross_validated_regret_ns, document["cross_validated_regret_ns"])
            chosen = selector.choose(self.store.features, self.store.target)
            label, _ = self.store.label(0.1)
            self.assertGreater(numpy.mean(chosen == label), 0.3)  # of some 60 clips
        for target, text in (([0.5], "target must hold whole numbers"), ([4], "indices of TARGETS"),
                             ([2**32], "indices of TARGETS"), ([0, 1], r"\(2, 22\), but has \(1, 22\)")):
            with self.assertRaisesRegex(ValueError, text):
                selector.choose(self.store.features[:1], target)
        with self.assertRaisesRegex(ValueError, "there is no model forest; it is one of knn, svm"):
            flinch.fit(self.store, "forest")
        with self.assertRaises(flinch.Error) as caught:
            flinch.fit(self.store, "knn", gamma=1)
        self.assertEqual(f"flinch: {caught.exception}\n",
                         run("train", self.file, "--out", self.path("no"), "--model", "knn", "--gamma", 1,
                             ).stderr)

    def test_a_bat_strikes_where_it_turns_to(self):
        file, path = self.folder / "kinds.flinchobs", self.folder / "kinds.flinch"
        flinch.simulate(self.library, file, 24, threats="kinds", seed=2)
        flinch.fit(flinch.Store(file), "knn", k=1).save(path)
        library = flinch.Library(path)
        shapes = [kind["shape"] for kind in library.kinds]
        self.assertEqual(set(shapes), {"ball", "blade", "fist", "rod"})
        bat = shapes.index("rod")
        self.assertGreater(library.kinds[bat]["length_m"][1], 0.5)

        def swing(turn, axis):
            return flinch.Threat([1, 0, 1.4], [0, 0, 0], 0.03, 0.9, bat, lasts_s=0.6, axis=axis,
                                 angular_velocity=[0, 0, turn], to_butt_m=0.1, to_tip_m=0.85)

        character = flinch.Character(library)
        inwards, outwards = swing(4, [0, 1, 0]), swing(-4, [0, 1, 0])
        answer, noticed = character.notice(inwards)
        self.assertIn(answer, ("ok", "outside_training"))
        numpy.testing.assert_array_equal(noticed.threat.axis, inwards.axis)
        self.assertLess(abs(noticed.time_to_impact_s - numpy.pi / 2 / 4), 0.1)
        self.assertEqual(character.notice(outwards), ("misses", None))
        with self.assertRaises(flinch.Error):
            character.notice(swing(4, [0, 2, 0]))

    def test_files_tell_how_they_were_made(self):
        def told(file):
            return json.loads(run("info", file, "--json").stdout)["provenance"]

        authored = flinch.author(startle=True)
        self.assertEqual(authored.provenance["command"], "author")
        self.assertEqual(flinch.ClipLibrary(self.library).provenance, told(self.library))
        self.assertEqual(self.store.provenance, told(self.file))
        self.assertEqual(self.store.provenance["inputs"][0]["provenance"]["command"], "author")
        fitted = flinch.fit(self.store, "knn", k=3, seed=5)
        path = self.folder / "provenance.flinch"
        fitted.save(path)
        self.assertEqual(fitted.provenance, told(path))
        self.assertEqual(fitted.provenance["seed"], 5)

    def test_compares_as_the_program_does(self):
        told = []
        mine = flinch.compare(self.file, models=["svm", "knn"], brawn=0.1,
                              progress=lambda what, *_: told.append(what))
        program = json.loads(self.succeed("compare", self.file, "--models", "svm,knn", "--brawn", 0.1,
                                          "--json"))
        # What is over before this thread looks is not told.
        self.assertEqual(told[-1], "fitting svm")
        self.assertLessEqual(set(told), {"fitting knn", "fitting svm"})
        for document in (mine, program):
            del document["timing"]
        self.assertEqual(json.dumps(mine), json.dumps(program))  # also where numbers are NaN


unittest.main()
