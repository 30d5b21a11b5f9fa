# SPDX-License-Identifier: MIT
"""The schemas of documents: each command has one, and each requires what its documents have. All tests of
this folder check documents against them (flinch_program.checked)."""

import copy
import json
import re
import sys
import unittest

from flinch_program import SCHEMA, ProgramTest, jsonschema, make_library, validator_of


def with_one_key_less(document):
    """The document without each of its own keys, and without each of those of its first elements."""
    for key, value in document.items():
        less = copy.deepcopy(document)
        del less[key]
        yield key, less
        inner = value[0] if isinstance(value, list) and value else value
        for inner_key in inner if isinstance(inner, dict) else ():
            less = copy.deepcopy(document)
            del (less[key][0] if isinstance(value, list) else less[key])[inner_key]
            yield f"{key}.{inner_key}", less


class Schemas(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "a.flinchlib"
        make_library(self.library)
        self.schema = json.loads(SCHEMA.read_text(encoding="utf-8"))

    def test_every_command_has_one_that_is_valid(self):
        jsonschema.Draft202012Validator.check_schema(self.schema)
        text = self.succeed("--help").stdout.partition("Subcommands:\n")[2].partition("\n\n")[0]
        commands = {line.split()[0] for line in text.splitlines()}
        self.assertLessEqual(commands, set(self.schema["$defs"]))
        for name in re.findall(r'"#/\$defs/(\w+)"', json.dumps(self.schema)):
            self.assertIn(name, self.schema["$defs"])

    def test_what_is_missing_is_missed(self):
        documents = {"info": self.document("info", self.library), "threats": self.document("threats"),
                     "simulate": self.lines("simulate", self.library, "--out", self.folder / "a.flinchobs",
                                            "-n", 4)[-1]}
        optional = {"kinds.flight", "clips.mirrored_from"}
        count = 0
        for command, document in documents.items():
            for key, less in with_one_key_less(document):
                if key not in optional:
                    self.assertFalse(validator_of(command).is_valid(less), f"{command} without {key}")
                    count += 1
            wrong = {**document, "kind": 7}
            self.assertFalse(validator_of(command).is_valid(wrong))
        self.assertGreater(count, 30)


if jsonschema is None:
    print("skipped: python3-jsonschema is missing; scripts/setup installs it")
    sys.exit(77)
unittest.main()
