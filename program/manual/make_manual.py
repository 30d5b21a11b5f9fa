#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""make_manual.py PROGRAM FOLDER: makes the man pages, man1/flinch.1 and one for each command, with
help2man, and the completion for bash, bash/flinch. All of it comes from the program's own --help."""

import pathlib
import re
import shutil
import subprocess
import sys

OPTION = re.compile(r"^  (-[\w,-]+)(?: ([A-Z]\S*(?: in \[[^\]]*\]\S*)?))?", re.MULTILINE)
VALUES = re.compile(r"\{([^}]*)\}")


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def commands_of(text):
    """The commands in the program's help, with what each does."""
    listed = text.partition("Subcommands:\n")[2].partition("\n\n")[0]
    return dict(re.fullmatch(r"  (\S+) +(.*)", line).groups() for line in listed.splitlines())


def options_of(text):
    """The options in a command's help: their names, and the values that they accept; None: no value,
    an empty list: any."""
    listed = text.partition("\nOptions:\n")[2].partition("\n\n")[0]
    found = {}
    for line in listed.splitlines():
        match = OPTION.match(line)
        if not match:
            continue
        values = None
        if match[2]:
            names = VALUES.search(line)
            values = [v.strip() for v in names[1].split(",")] if names else []
            values = [value for value in values if not value.isupper() and "." not in value]
        for name in match[1].split(","):
            found[name] = values
    return found


def write_man_page(program, words, summary, version, path):
    executable = " ".join([str(program), *words])
    text = output_of("help2man", "--no-info", "--name", summary[0].lower() + summary[1:],
                     "--version-string", version, "--source", version, "--manual", "Flinch", executable)
    title = "-".join(["flinch", *words])
    text = re.sub(r'^\.TH \S+', f".TH {title.upper()}", text, count=1, flags=re.MULTILINE)
    text = re.sub(r"(\.SH NAME\n).* \\- ", rf"\1{title} \\- ", text, count=1)
    path.write_text(text, encoding="utf-8")


def completion(commands, options):
    lines = ["# Completion of flinch's commands, options and their values; made of its --help.",
             "_flinch() {",
             "  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} words=",
             "  if ((COMP_CWORD == 1)); then",
             f'    COMPREPLY=($(compgen -W "{" ".join([*commands, "--help", "--version"])}" -- "$word"))',
             "    return",
             "  fi",
             '  case "${COMP_WORDS[1]} $previous" in']
    for command in commands:
        for name, values in options[command].items():
            if values:
                lines.append(f'    "{command} {name}") words="{" ".join(values)}" ;;')
    lines += ["  esac", "  if [[ -z $words && $word == -* ]]; then", "    case ${COMP_WORDS[1]} in"]
    lines += [f'      {command}) words="{" ".join(options[command])}" ;;' for command in commands]
    lines += ["    esac", "  fi", "  if [[ -n $words ]]; then",
              '    COMPREPLY=($(compgen -W "$words" -- "$word"))', "  else",
              '    compopt -o filenames 2>/dev/null', '    COMPREPLY=($(compgen -f -- "$word"))', "  fi", "}",
              "complete -F _flinch flinch"]
    return "\n".join(lines) + "\n"


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    for part in ("man1", "bash"):
        (folder / part).mkdir(parents=True)
    text = output_of(program, "--help")
    version = output_of(program, "--version").strip()
    commands = commands_of(text)
    write_man_page(program, [], text.splitlines()[0].rstrip("."), version, folder / "man1/flinch.1")
    options = {}
    for command, summary in commands.items():
        options[command] = options_of(output_of(program, command, "--help"))
        write_man_page(program, [command], summary, version, folder / f"man1/flinch-{command}.1")
    (folder / "bash/flinch").write_text(completion(commands, options), encoding="utf-8")


main()
