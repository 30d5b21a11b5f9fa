#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The views of docs/trials.sql hold what a store's bytes hold, and the queries of docs/store.md run on them."""

import pathlib
import re
import sqlite3
import struct
import unittest

from flinch_program import ProgramTest, make_library
from store_costs import trials_of

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
VIEWS = (DOCS / "trials.sql").read_text(encoding="utf-8")
QUERIES = re.findall(r"^```sql\n(.*?)^```$", (DOCS / "store.md").read_text(encoding="utf-8"), re.M | re.S)


class Sql(ProgramTest):
    def setUp(self):
        super().setUp()
        library = self.folder / "a.flinchlib"
        make_library(library)
        self.path = self.folder / "a.flinchobs"
        self.succeed("simulate", library, "--out", self.path, "-n", 60, "--first", 3)

    def open(self, path=None):
        store = sqlite3.connect(path or self.path)
        self.addCleanup(store.close)
        store.executescript(VIEWS)
        return store

    def expected(self, store):
        """The trials and the impulses by another decoder."""
        trials, impulses = [], []
        for number, blob in store.execute("SELECT number, trials FROM observation"):
            for clip, work, impulse in trials_of(blob):
                trials.append((number, clip, work))
                impulses += [(number, clip, body, value) for body, value in impulse.items()]
        return sorted(trials), sorted(impulses)

    def test_the_views_hold_every_trial_to_the_bit(self):
        store = self.open()
        trials, impulses = self.expected(store)
        self.assertGreater(len(impulses), 100)
        self.assertEqual(sorted(store.execute("SELECT * FROM trial")), trials)
        self.assertEqual(sorted(store.execute("SELECT number, clip, body, impulse_ns FROM impulse")), impulses)
        names = dict(store.execute("SELECT body, name FROM body"))
        self.assertEqual({names[body] == name for body, name in store.execute("SELECT body, name FROM impulse")},
                         {True})

    def test_any_number_and_clip_is_read(self):
        floats = [0.0, 1.0, -1.5, 0.1, 1e-45, 1.1754942e-38, 1e-30, 2e-20, 16777215.0, 16777216.0, 1e9, -1e-9]
        clips = [0, 1, 30, 31, 32, 255, 256, 2303, 4350]
        blob, before = b"", -1
        for i, clip in enumerate(clips):
            hits = [0, 17, 1][i % 3]
            blob += struct.pack("<Hf", (clip - before) << 5 | hits, floats[i])
            for body in range(hits):
                blob += struct.pack("<Bf", body, floats[(i + body) % len(floats)])
            before = clip
        store = self.open()
        store.execute("UPDATE observation SET trials = CASE number WHEN 3 THEN ? WHEN 4 THEN x'' ELSE trials END",
                      (blob,))
        trials, impulses = self.expected(store)
        self.assertEqual(sorted(store.execute("SELECT * FROM trial")), trials)
        self.assertEqual(sorted(store.execute("SELECT number, clip, body, impulse_ns FROM impulse")), impulses)

    def test_the_queries_of_the_page_answer(self):
        store = self.open()
        trials, impulses = self.expected(store)
        least, bodies, avoided = (store.execute(query).fetchall() for query in QUERIES)
        names = dict(store.execute("SELECT clip, name FROM clip"))
        (idle,), = store.execute("SELECT value FROM meta WHERE key = 'idle_clip'")
        total = {}
        for number, clip, _, value in impulses:
            total[number, clip] = total.get((number, clip), 0) + value
        means = {}
        for clip in {clip for _, clip, _ in trials}:
            of_clip = [total.get((number, clip), 0) for number, one, _ in trials if one == clip]
            means[names[clip]] = (len(of_clip), sum(of_clip) / len(of_clip))
        self.assertEqual(len(least), min(10, len(means)))
        for name, count, mean in least:
            self.assertEqual(count, means[name][0])
            self.assertAlmostEqual(mean, means[name][1], delta=1e-9)
        self.assertEqual([mean for *_, mean in least], sorted(mean for *_, mean in least))
        self.assertEqual(sum(hits for _, hits, *_ in bodies), sum(clip == idle for _, clip, *_ in impulses))
        self.assertEqual(max(most for *_, most in bodies), max(v for _, clip, _, v in impulses if clip == idle))
        targets = dict(store.execute("SELECT number, target FROM observation"))
        for target, scenarios, avoidable, harmless in avoided:
            of_target = [(n, clip) for n, clip, _ in trials if targets[n] == target]
            self.assertEqual(scenarios, len({n for n, _ in of_target}))
            self.assertEqual(avoidable, len({n for n, clip in of_target if (n, clip) not in total}))
            self.assertEqual(harmless, sum(clip == idle and (n, clip) not in total for n, clip in of_target))

    def test_the_file_stays_as_it_is(self):
        before = self.path.read_bytes()
        store = self.open()
        store.execute("SELECT count(*) FROM trial").fetchall()
        store.close()
        self.assertEqual(self.path.read_bytes(), before)
        self.succeed("info", self.path)


unittest.main()
