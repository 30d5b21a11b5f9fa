#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Libraries, stores, selectors and reports tell how they were made; what is made does not depend on names of
files or folders."""

import contextlib
import json
import os
import re
import shutil
import sqlite3
import subprocess
import unittest

from flinch_program import FLINCH, ProgramTest, make_library

BALL = '[[kind]]\nname = "ball"\nspeed_mps = [12, 15]\n'


def xxh64(data):
    """XXH64 with seed 0, as its specification has it: https://github.com/Cyan4973/xxHash."""
    mask = (1 << 64) - 1
    p1, p2, p3, p4, p5 = (0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9, 0x85EBCA77C2B2AE63,
                          0x27D4EB2F165667C5)

    def rotl(x, n):
        return ((x << n) | (x >> (64 - n))) & mask

    def mix(lane, word):
        return rotl((lane + word * p2) & mask, 31) * p1 & mask

    place, size = 0, len(data)
    hash_ = p5
    if size >= 32:
        lanes = [(p1 + p2) & mask, p2, 0, -p1 & mask]
        while size - place >= 32:
            for i in range(4):
                lanes[i] = mix(lanes[i], int.from_bytes(data[place:place + 8], "little"))
                place += 8
        hash_ = sum(rotl(lane, n) for lane, n in zip(lanes, (1, 7, 12, 18))) & mask
        for lane in lanes:
            hash_ = ((hash_ ^ mix(0, lane)) * p1 + p4) & mask
    hash_ = (hash_ + size) & mask
    while size - place >= 8:
        hash_ = (rotl(hash_ ^ mix(0, int.from_bytes(data[place:place + 8], "little")), 27) * p1 + p4) & mask
        place += 8
    if size - place >= 4:
        word = int.from_bytes(data[place:place + 4], "little")
        hash_ = (rotl(hash_ ^ (word * p1 & mask), 23) * p2 + p3) & mask
        place += 4
    for byte in data[place:]:
        hash_ = rotl(hash_ ^ (byte * p5 & mask), 11) * p1 & mask
    hash_ = (hash_ ^ (hash_ >> 33)) * p2 & mask
    hash_ = (hash_ ^ (hash_ >> 29)) * p3 & mask
    return f"{hash_ ^ (hash_ >> 32):016x}"


def sealed(content, header):
    """A file of Flinch with this content and the kind and version of the header."""
    return header[:8] + bytes.fromhex(xxh64(content))[::-1] + content


class Provenance(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "a.flinchlib"
        make_library(self.library)
        self.store = self.folder / "a.flinchobs"
        self.selector = self.folder / "a.flinch"
        self.threats = self.folder / "ball.toml"
        self.threats.write_text(BALL)

    def simulate(self, out, *options, library=None, threats=None):
        self.succeed("simulate", library or self.library, "--out", out, "--threats", threats or self.threats,
                     "--seed", 7, *options)
        return out.read_bytes()

    def train(self, *options):
        self.succeed("train", self.store, "--out", self.selector, "--model", "knn", *options)
        return self.selector.read_bytes()

    def test_a_selector_tells_the_whole_way_to_it(self):
        self.simulate(self.store, "-n", 30)
        self.train("-k", 3, "--brawn", 0.25)
        selector = self.document("info", self.selector)
        store = self.document("info", self.store)
        version = self.succeed("--version").stdout.split()[1]
        library = {"role": "library", "hash": store["library_hash"]}
        threats = {"role": "threats", "name": "ball.toml", "hash": xxh64(self.threats.read_bytes())}
        self.assertEqual(store["provenance"],
                         {"flinch_version": version, "command": "simulate", "options": {}, "seed": 7,
                          "inputs": [library, threats]})
        self.assertEqual(selector["provenance"],
                         {"flinch_version": version, "command": "train",
                          "options": {"model": "knn", "brawn": "0.25", "k": "3"}, "seed": 7,
                          "inputs": [{"role": "store", "hash": store["hash"],
                                      "provenance": store["provenance"]}]})
        summary = self.document("train", self.store, "--out", self.folder / "again", "--model", "knn", "-k", 3,
                                "--brawn", 0.25)
        training = selector["training"]
        self.assertEqual(training["scenarios"], 30)
        self.assertEqual(training["parameters"], summary["parameters"])
        self.assertEqual(training["cross_validated_regret_ns"], summary["cross_validated_regret_ns"])
        self.assertEqual(training["distribution"], store["distribution"])
        self.assertEqual(training["cross_validated_protection"],
                         1 - training["cross_validated_regret_ns"] / training["idle_regret_ns"])

    def test_threads_change_no_bit_of_a_selector(self):
        self.simulate(self.store, "-n", 60)
        command = [FLINCH, "train", str(self.store), "--out", str(self.selector), "--model", "network", "--force",
                   "--quiet"]
        files = []
        for count in (1, 3):
            with subprocess.Popen([*command, "--threads", str(count)], stdout=subprocess.DEVNULL) as process:
                seen = 0
                while process.poll() is None:
                    with contextlib.suppress(OSError):
                        seen = max(seen, len(os.listdir(f"/proc/{process.pid}/task")))
                self.assertEqual((process.returncode, seen), (0, count))
            files.append(self.selector.read_bytes())
        self.assertEqual(files[0], files[1])
        for model in ("svm", "pairwise_cost", "knn_cost"):
            files = []
            for count in (1, 2, 5):
                self.succeed("train", self.store, "--out", self.selector, "--model", model, "--force", "--threads",
                             count)
                files.append(self.selector.read_bytes())
            self.assertEqual(files, [files[0]] * 3, model)

    def test_the_regret_of_standing_still_is_that_of_the_report(self):
        self.simulate(self.store, "-n", 40)
        self.train()
        fitted = self.document("info", self.selector)["training"]["idle_regret_ns"]
        # Tested on the scenarios that it was fitted to, idle has the same regret.
        other = self.folder / "other.flinchobs"
        self.simulate(other, "-n", 40, "--first", 40)
        report = self.document("compare", other, "--test", self.store, "--models", "knn")
        idle, = (row for row in report["rows"] if row["name"] == "idle")
        self.assertAlmostEqual(fitted, idle["regret"], delta=1e-9)

    def test_a_report_tells_of_its_stores(self):
        self.simulate(self.store, "-n", 20)
        test = self.folder / "test.flinchobs"
        self.simulate(test, "-n", 20, "--first", 20)
        report = json.loads(self.succeed("compare", self.store, "--test", test, "--models", "knn", "--curves",
                                         "--json").stdout)
        made = report["provenance"]
        self.assertEqual((made["command"], made["options"], made["seed"]),
                         ("compare", {"models": "knn", "curves": "true"}, 7))
        self.assertEqual([(one["role"], one["hash"]) for one in made["inputs"]],
                         [("store", self.document("info", self.store)["hash"]),
                          ("test", self.document("info", test)["hash"])])

    def test_names_and_folders_of_files_change_no_bit(self):
        self.simulate(self.store, "-n", 20)
        selector = self.train()
        elsewhere = self.folder / "other folder"
        elsewhere.mkdir()
        library, threats = elsewhere / "b.flinchlib", elsewhere / "ball.toml"
        shutil.copy(self.library, library)
        shutil.copy(self.threats, threats)
        store = self.simulate(elsewhere / "b", "-n", 20, library=library, threats=threats)
        self.assertEqual(self.store.read_bytes(), store)
        self.store = elsewhere / "b"
        self.assertEqual(self.train(), selector)
        for data in (store, selector):
            self.assertNotIn(str(self.folder).encode(), data)

    def test_parts_of_a_run_make_the_whole_of_it(self):
        whole = self.simulate(self.store, "-n", 20)
        parts = [self.folder / "1", self.folder / "2"]
        self.simulate(parts[0], "-n", 12)
        self.simulate(parts[1], "-n", 8, "--first", 12)
        merged = self.folder / "merged"
        self.succeed("merge", *parts, "--out", merged)
        self.assertEqual(merged.read_bytes(), whole)

    def test_a_library_has_the_hash_of_its_content_however_it_was_made(self):
        person = self.folder / "mean.toml"
        person.write_text("")
        first, second = self.folder / "first.flinchlib", self.folder / "second.flinchlib"
        self.succeed("author", "--out", first, "--character", person)
        self.succeed("author", "--out", second, "--character", first)
        self.assertNotEqual(first.read_bytes(), second.read_bytes())
        documents = [self.document("info", path) for path in (first, second)]
        self.assertEqual(documents[0]["hash"], documents[1]["hash"])
        self.assertEqual(documents[0]["provenance"]["inputs"],
                         [{"role": "character", "name": "mean.toml", "hash": xxh64(b"")}])
        self.assertEqual(documents[1]["provenance"]["inputs"],
                         [{"role": "character", "hash": documents[0]["hash"],
                           "provenance": documents[0]["provenance"]}])
        stores = [self.folder / "first", self.folder / "second"]
        for library, store in zip((first, second), stores):
            self.simulate(store, "-n", 2, library=library)
        with sqlite3.connect(stores[0]) as store:
            (file,), = store.execute("SELECT file FROM library")
        self.assertEqual(documents[0]["hash"], xxh64(file[16:]))
        self.succeed("merge", *stores, "--out", self.folder / "merged")  # of one library

    def test_text_shows_every_step(self):
        self.simulate(self.store, "-n", 20)
        self.train("-k", 3)
        lines = self.succeed("info", self.selector).stdout.splitlines()
        made = next(i for i, line in enumerate(lines) if line.startswith("made by: "))
        self.assertRegex(lines[made], r"^made by: Flinch \S+, flinch train --model knn -k 3, seed 7$")
        self.assertRegex(lines[made + 1], r"^  store [0-9a-f]{16}, made by Flinch \S+, flinch simulate, seed 7$")
        self.assertRegex(lines[made + 3], rf"^    threats ball.toml {xxh64(BALL.encode())}$")
        self.assertIn("trained on 20 scenarios", lines)

    def test_no_name_in_the_text_passes_for_two(self):
        names = {"ball, seed 8.toml": "'ball, seed 8.toml'", "it's.toml": "'it'\\''s.toml'", "bälle.toml": "bälle.toml"}
        for name, word in names.items():
            self.threats = self.folder / name
            self.threats.write_text(BALL)
            self.store.unlink(missing_ok=True)
            self.simulate(self.store, "-n", 2)
            text = self.succeed("info", self.store).stdout
            self.assertIn(f"\n  threats {word} {xxh64(BALL.encode())}\n", text)
            self.assertIn(", flinch simulate, seed 7\n", text)

    def test_text_has_each_parameter_once(self):
        self.simulate(self.store, "-n", 20)
        for model, shared in [("knn", ["k"]), ("network", ["members", "hidden"]), ("svm", [])]:
            self.succeed("train", self.store, "--out", self.selector, "--model", model, "--force")
            text = self.succeed("info", self.selector).stdout
            document = self.document("info", self.selector)
            parameters = document["training"]["parameters"]
            self.assertEqual([name for name in parameters if name in document], shared)
            for name, value in parameters.items():
                self.assertEqual(re.findall(rf"\b{name}\b.*", text), [f"{name}: {value}"])

    def test_a_forged_provenance_is_refused(self):
        self.simulate(self.store, "-n", 20)
        data = self.train()
        for old, new in [(b'"command"', b'"commant"'), (b'"train"', b'\\u001b '), (b'"seed":7', b'"seed":-'),
                         (b'"inputs":[', b'"inputs":{'), (b'"role":"store"', b'"role":"st\x1bre"')]:
            self.assertEqual(len(old), len(new))
            self.assertIn(old, data)
            forged = self.folder / "forged.flinch"
            forged.write_bytes(sealed(data[16:].replace(old, new), data))
            with self.subTest(new=new):
                for options in ([], ["--json"]):
                    line = self.fail_with(1, "info", forged, *options)
                    self.assertRegex(line, "(provenance|record of its training) is damaged")
        with sqlite3.connect(self.store) as store:
            store.execute("UPDATE meta SET value = value || ' ' WHERE key = 'provenance'")
        self.assertIn("damaged", self.fail_with(1, "info", self.store))

    def test_imported_motion_is_known_by_its_hashes(self):
        self.simulate(self.store, "-n", 20)
        self.train()
        clip = self.folder / "stand.bvh"
        self.succeed("respond", self.selector, "--out", clip)
        imported = self.folder / "imported.flinchlib"
        subprocess.run([FLINCH, "import", clip.name, "--rate", "30", "--out", imported], check=True,
                       cwd=self.folder, capture_output=True)
        made = self.document("info", imported)["provenance"]
        self.assertEqual((made["command"], made["options"]), ("import", {"rate": "30"}))
        self.assertEqual(made["inputs"],
                         [{"role": "motion", "name": "stand.bvh", "hash": xxh64(clip.read_bytes())}])
        manifest = self.folder / "library.toml"
        manifest.write_text('[library]\nrate = 30\n[[idle]]\nname = "stand"\nfile = "stand.bvh"\n')
        for rate, usual in [("60", []), ("30", ["--manifest", manifest])]:
            files = [self.folder / name for name in ("said.flinchlib", "unsaid.flinchlib")]
            self.succeed("import", clip, *usual, "--out", files[0], "--force", "--rate", rate)
            self.succeed("import", clip, *usual, "--out", files[1], "--force")
            self.assertEqual(files[0].read_bytes(), files[1].read_bytes(), rate)
            self.assertEqual(self.document("info", files[0])["provenance"]["options"], {})

    def test_defaults_that_are_said_change_no_bit(self):
        said = self.folder / "said.flinchlib"
        unsaid = self.folder / "unsaid.flinchlib"
        weak = ["--weakest", 1, "--scenarios", 200, "--population", 8]
        for given, defaults in [(["--generations", 1], ["--population", 400, "--tournament", 4]),
                                (weak, ["--generations", 20, "--mutation", "A"])]:
            self.succeed("evolve", self.library, "--out", unsaid, "--force", *given)
            self.succeed("evolve", self.library, "--out", said, "--force", *given, *defaults)
            self.assertEqual(said.read_bytes(), unsaid.read_bytes(), given)

    def test_nothing_tells_when_where_and_by_whom(self):
        self.simulate(self.store, "-n", 2)
        made = json.dumps(self.document("info", self.store)["provenance"])
        self.assertIsNone(re.search(r"/|20\d\d-", made), made)


unittest.main()
