#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails if the C interface's shared library exports or needs what it must not, or is too large.

Usage: check_c_library.py HEADER LIBRARY SONAME [KIBIBYTES]

Every function that HEADER declares is exported by LIBRARY, and nothing else is; its name for
programs is SONAME; stripped it weighs at most KIBIBYTES.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

DECLARATION = re.compile(r"^FLINCH_API[^;(]*?\b(flinch_\w+)\(", re.MULTILINE)


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def exported(library: str):
    lines = output_of("nm", "--dynamic", "--defined-only", library).splitlines()
    return {line.split()[-1] for line in lines}


def stripped_size(library: str):
    with tempfile.TemporaryDirectory() as folder:
        stripped = Path(folder) / "stripped.so"
        output_of("strip", "-o", str(stripped), library)
        return stripped.stat().st_size


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    header, library, soname = sys.argv[1:4]
    declared = set(DECLARATION.findall(Path(header).read_text(encoding="utf-8")))
    shown = exported(library)
    violations = [f"{name} is declared and not exported" for name in sorted(declared - shown)]
    violations += [f"{name} is exported and not declared" for name in sorted(shown - declared)]
    if f"[{soname}]" not in output_of("readelf", "--dynamic", "--wide", library):
        violations.append(f"its soname is not {soname}")
    if not declared:
        violations.append("checked no function")
    size = stripped_size(library)
    if len(sys.argv) > 4 and size > 1024 * int(sys.argv[4]):
        violations.append(f"stripped it weighs more than {sys.argv[4]} KiB")
    print("\n".join(violations))
    print(f"{len(declared)} functions, {size / 1024:.1f} KiB stripped, {len(violations)} violations")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
