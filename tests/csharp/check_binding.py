#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails unless the C# binding has each function, struct and constant of flinch.h: functions with as many arguments,
structs with the same fields in the same order, enums with the same values.

Usage: check_binding.py HEADER CSHARP...
"""

import pathlib
import re
import sys

# What C# does without, and why.
UNUSED = {
    "flinch_character_place": "flinch_character_place_in_stance does the same",
    "flinch_target_name": "the names of an enum are C#'s own",
    "flinch_phase_name": "as above",
    "flinch_foreseen_name": "as above",
}
STRUCTS = {"flinch_kind": "ThreatKind"}  # which are not called as in C
BITS = {"int": "i", "uint": "i", "float": "f", "IntPtr": "p"}


def without_comments(path):
    return re.sub(r"/\*.*?\*/|//[^\n]*", " ", pathlib.Path(path).read_text(encoding="utf-8"), flags=re.S)


def argument_count(listed):
    listed = re.sub(r"\[[^\]]*\]", "", listed).strip()
    return 0 if listed in ("", "void") else listed.count(",") + 1


def pascal(name):
    return "".join(word.capitalize() for word in name.split("_"))


class Header:
    def __init__(self, text):
        self.functions = {name: argument_count(listed) for name, listed in
                          re.findall(r"FLINCH_API [\w\s*]*?(flinch_\w+)\(([^;]*)\);", text)}
        self.constants = {name: int(value) for name, value in re.findall(r"#define (FLINCH_\w+)\s+(\d+)", text)}
        self.enums = [{name: int(value) for name, value in re.findall(r"FLINCH_(\w+) = (-?\d+)", block)}
                      for block in re.findall(r"enum \{(.*?)\}", text, re.S)]
        self.structs = {}
        for body, name in re.findall(r"typedef struct flinch_\w+ \{(.*?)\} (flinch_\w+);", text, re.S):
            self.structs[name] = "".join(self.fields(line) for line in body.split(";") if line.strip())

    def fields(self, line):
        line = line.strip()
        if "*" in line:
            return "p"
        kind, declared = line.split(" ", 1)
        one = self.structs.get(kind) or {"uint32_t": "i", "int32_t": "i", "float": "f"}[kind]
        made = ""
        for field in declared.split(","):
            count = 1
            for size in re.findall(r"\[(\w+)\]", field):
                count *= int(size) if size.isdigit() else self.constants[size]
            made += one * count
        return made


class Binding:
    def __init__(self, text):
        self.functions = {name: argument_count(listed)
                          for name, listed in re.findall(r"static extern \w+ (flinch_\w+)\((.*?)\);", text)}
        self.enums = [{name.upper(): int(value) for name, value in re.findall(r"(\w+) = (-?\d+)", block)}
                      for block in re.findall(r"public enum \w+ \{(.*?)\}", text, re.S)]
        self.enum_names = set(re.findall(r"public enum (\w+)", text))
        self.constants = {name: value for _, name, value in re.findall(r"(const int) (\w+) = (\d+)", text)}
        self.structs = {}
        for name, body in re.findall(r"struct (\w+) \{(.*?)\n\}", text, re.S):
            fields = re.findall(r"^  (?:public|private) (fixed )?(\w+) ([^;{}()=]+);", body, re.M)
            self.structs[name] = "".join(self.fields(*field) for field in fields)

    def fields(self, fixed, kind, declared):
        one = "i" if kind in self.enum_names else BITS.get(kind) or self.structs[kind]
        if not fixed:
            return one * (declared.count(",") + 1)
        count = 1
        for factor in re.search(r"\[(.*)\]", declared)[1].split("*"):
            word = factor.strip().split(".")[-1]
            count *= int(self.constants.get(word, word))
        return ("?" if kind == "int" else one) * count  # structs, which C# has no fixed buffers of


def are_alike(c, csharp):
    return len(c) == len(csharp) and all(b in ("?", a) for a, b in zip(c, csharp))


def without_prefix(names):
    """The names less the words that all of them begin with."""
    words = [name.split("_") for name in names]
    shared = 0
    while all(len(one) > shared + 1 and one[shared] == words[0][shared] for one in words):
        shared += 1
    return ["".join(one[shared:]) for one in words]


def problems(header, binding):
    for name, count in header.functions.items():
        if name in UNUSED:
            if name in binding.functions:
                yield f"{name} is said to be unused, but is there"
        elif name not in binding.functions:
            yield f"C# has no {name}"
        elif binding.functions[name] != count:
            yield f"{name} has {count} arguments, in C# {binding.functions[name]}"
    for name in {*binding.functions, *UNUSED} - {*header.functions}:
        yield f"flinch.h has no {name}"
    for name, fields in header.structs.items():
        other = STRUCTS.get(name, pascal(name[len("flinch_"):]))
        if other not in binding.structs:
            yield f"C# has no struct {other} for {name}"
        elif not are_alike(fields, binding.structs[other]):
            yield f"the fields of {other} are {binding.structs[other]}, those of {name} {fields}"
    for enum in header.enums:
        values = [value for value in enum.values() if value >= 0]
        wanted = dict(zip(without_prefix([name for name, value in enum.items() if value >= 0]), values))
        if wanted not in binding.enums:
            yield f"C# has no enum with {wanted}"


def main():
    header = Header(without_comments(sys.argv[1]))
    binding = Binding("\n".join(without_comments(path) for path in sys.argv[2:]))
    if len(header.functions) < 60 or len(header.structs) < 20 or len(header.enums) < 7:
        sys.exit("flinch.h was not understood")
    found = list(problems(header, binding))
    print("\n".join(found) if found else f"{len(header.functions)} functions, {len(header.structs)} structs")
    sys.exit(bool(found))


main()
