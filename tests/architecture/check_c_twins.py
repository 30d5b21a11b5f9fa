#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails if the table in docs/embedding.md lacks a function that a game calls in C++, or names one of C or C++
that there is not.

Usage: check_c_twins.py ROOT
"""

import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1])
CLASSES = {"Library": "runtime/library.h", "Character": "runtime/character.h",
           "ReactingCharacter": "reaction/reacting_character.h"}
FREE = {"make_motion_graph": "runtime/character.h", "lookahead::perceive": "lookahead/look_ahead.h"}
METHOD = re.compile(r"^  (?!explicit|~|//|friend|using|return)[\w:<>&*, ]+? [&*]?(\w+)\(", re.MULTILINE)


def methods_of(name):
    """The public methods of a class, without constructors and operators."""
    text = (ROOT / CLASSES[name]).read_text(encoding="utf-8")
    text = text[text.index(f"class {name} {{"):]
    text = text[text.index("public:"):text.index(" private:")]
    return {method for method in METHOD.findall(text) if method not in (name, "operator", "whole_body")}


def rows():
    """The table: what it says of C++, and what of C."""
    page = (ROOT / "docs/embedding.md").read_text(encoding="utf-8")
    table = page[page.index("| C++ | C, each"):].split("\n\n")[0]
    return [line.strip("|").split(" | ") for line in table.splitlines()[2:]]


def faults():
    declared = set(re.findall(r"\bflinch_(\w+)\(", (ROOT / "runtime/c/flinch.h").read_text(encoding="utf-8")))
    told = {name: set() for name in CLASSES}
    free = set()
    for cpp, c in rows():
        owner, colon, _ = cpp.partition("`: ")
        names = re.findall(r"`([\w:]+)`", cpp)
        if colon:
            told[owner.strip(" `")] |= set(names[1:])
        else:
            free |= set(names)
        for name in re.findall(r"`(\w+)`", c):
            if name not in declared and name != "Search":
                yield f"docs/embedding.md names flinch_{name}, which flinch.h does not declare"
    for name, listed in told.items():
        methods = methods_of(name)
        if len(methods) < 5:
            yield f"{CLASSES[name]}: found {len(methods)} functions of {name}"
        for method in sorted(methods - listed):
            yield f"docs/embedding.md says of {name}::{method} neither its function in C nor why there is none"
        for method in sorted(listed - methods):
            yield f"docs/embedding.md names {name}::{method}, which there is not"
    for name in sorted(set(FREE) - free):
        yield f"docs/embedding.md does not name {name}"


found = list(faults())
print("\n".join(found) if found else f"{sum(len(methods_of(name)) for name in CLASSES)} functions have a twin or a reason")
sys.exit(1 if found else 0)
