#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails when the list of public headers breaks its rules.

Usage: check_public_headers.py ROOT HEADERS MAX PAGE

HEADERS is a file with the public headers, a path under ROOT per line. Each must exist, include only
other public headers by #include "...", have a comment for each declaration at namespace scope, and
stand on the page PAGE. There are at most MAX.
"""

import re
import sys
from pathlib import Path

FORWARD = re.compile(r"(struct|class) \w+;")
SCOPE = re.compile(r'(inline )?namespace\b|extern "C"')


def uncommented(text):
    """The first lines of declarations at namespace scope that no comment goes with.

    Relies on the format of the code: at namespace scope a declaration begins in the first column,
    and its other lines do not.
    """
    found = []
    previous = ""
    is_in_comment = is_template = False
    for line in text.splitlines():
        starts = re.match(r"[A-Za-z_\[]", line) and not is_in_comment
        if starts and not is_template and not SCOPE.match(line) and not FORWARD.match(line):
            above = previous.startswith("///") or previous.endswith("*/")
            if not above and not re.search(r"///<|/\*", line):
                found.append(line)
        if not is_in_comment:
            is_template = line.startswith("template ")
        comment = line.rfind("/*")
        if comment >= 0 or is_in_comment:
            is_in_comment = "*/" not in line[max(comment, 0):]
        previous = line
    return found


def check(root, headers, most, page):
    """The violations, a line for each."""
    found = []
    if len(headers) > most:
        found.append(f"{len(headers)} public headers, but at most {most} may be")
    listed = page.read_text(encoding="utf-8")
    for header in headers:
        path = root / header
        if not path.is_file():
            found.append(f"{header}: does not exist")
            continue
        text = path.read_text(encoding="utf-8")
        found += [f"{header}: includes {included}, which is not public"
                  for included in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE)
                  if included not in headers]
        found += [f"{header}: no comment for: {line}" for line in uncommented(text)]
        if f"`{header}`" not in listed:
            found.append(f"{header}: is not on {page.name}")
    return found


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    headers = Path(sys.argv[2]).read_text(encoding="utf-8").split()
    found = check(Path(sys.argv[1]), headers, int(sys.argv[3]), Path(sys.argv[4]))
    if not headers:
        found.append("no header is public")
    print("\n".join([*found, f"{len(headers)} public headers, {len(found)} violations"]))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
