#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""manual_test.py PROGRAM MAKE_MANUAL FOLDER: the man pages and the completion that MAKE_MANUAL makes into
FOLDER say what the program's --help says: each command and each of its options, and no other."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

PROGRAM, MAKE_MANUAL, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
COMPLETE = """
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_flinch
printf '%s\\n' "${COMPREPLY[@]}"
"""


def output_of(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=True,
                          **options).stdout


def complete(*words):
    return set(output_of("bash", "-c", COMPLETE, "bash", FOLDER / "bash/flinch", "flinch", *words,
                         cwd=FOLDER).split())


def options_in(text):
    """All words that begin a line of help with a dash."""
    return {name for names in re.findall(r"^ +(-[^\s=]+)", text, re.MULTILINE) for name in names.split(",")}


def words_of(page):
    """What a reader sees of a man page."""
    text = page.read_text(encoding="utf-8")
    return re.sub(r"\\f[A-Z]|\\,|\\/", "", text).replace(r"\-", "-")


def warnings_of(page):
    return subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page], check=True,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          env={**os.environ, "LC_ALL": "C.UTF-8", "MANROFFSEQ": ""}).stderr


subprocess.run([sys.executable, MAKE_MANUAL, PROGRAM, FOLDER], check=True)
listed = output_of(PROGRAM, "--help").partition("Subcommands:\n")[2].partition("\n\n")[0]
commands = {line.split()[0] for line in listed.splitlines()}
assert len(commands) > 15, commands
pages = {page.name for page in (FOLDER / "man1").iterdir()}
assert pages == {"flinch.1", *(f"flinch-{command}.1" for command in commands)}, pages ^ commands
assert complete("") == commands | {"--help", "--version"}
assert complete("tra") == {"train", "train-realism"}
count = 0
for command in sorted(commands):
    text = output_of(PROGRAM, command, "--help")
    options = options_in(text)
    count += len(options)
    assert complete(command, "-") == options, (command, complete(command, "-") ^ options)
    page = FOLDER / f"man1/flinch-{command}.1"
    shown = words_of(page)
    missing = {name for name in options if not re.search(rf"(?<![\w-]){name}(?![\w-])", shown)}
    assert not missing, (command, missing)
    for sentence in re.findall(r"^ {28,}(\S.*)$", text, re.MULTILINE):  # what options mean
        assert sentence in shown, (command, sentence)
    if shutil.which("man"):
        assert not warnings_of(page), warnings_of(page)
assert complete("compare", "--models", "knn") == {"knn", "knn_cost"}
(FOLDER / "a.flinchobs").write_text("")
assert complete("compare", "a") == {"a.flinchobs"}
assert complete("compare", "--report", "b") == {"bash"}
print(f"{len(pages)} pages, {count} options")
