#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles each installed header alone, as a game may include it, and fails on a warning.

Usage: check_headers.py INCLUDE EIGEN COUNT COMPILER...

INCLUDE is the folder of the installed headers; those of C++ are in its folder `flinch`. EIGEN is
Eigen's folder, which counts as a system's: its warnings are its own. There must be COUNT headers.

Almost all of the time goes into <Eigen/Geometry>. Each compiler reads it once, and headers that
include it, themselves or by another, take it in precompiled form. All others do without.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

FLAGS = "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror".split()
GEOMETRY = "Eigen/Geometry"


def includes_geometry(root, header):
    """Whether the header includes it, or another header of ours that does."""
    text = (root / header).read_text(encoding="utf-8")
    if f"#include <{GEOMETRY}>" in text:
        return True
    others = re.findall(r'^#include "([^"]+)"', text, re.MULTILINE)
    return any((root / other).is_file() and includes_geometry(root, other) for other in others)


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    include, eigen = Path(sys.argv[1]), sys.argv[2]
    root = include / "flinch"
    headers = sorted(path.relative_to(root) for path in root.rglob("*.h"))
    headers += [Path("..", path.name) for path in sorted(include.glob("*.h"))]
    wrong = [] if len(headers) == int(sys.argv[3]) else [f"not {sys.argv[3]} headers"]
    if not headers:
        sys.exit(f"there is no header in {include}")
    for compiler in sys.argv[4:]:
        command = [compiler, "-std=c++20", *FLAGS, f"-I{root}", "-isystem", eigen]
        with tempfile.TemporaryDirectory() as folder:
            geometry = Path(folder, "geometry.h")
            geometry.write_text(f"#include <{GEOMETRY}>\n", encoding="utf-8")
            subprocess.run([*command, "-x", "c++-header", geometry, "-o", f"{geometry}.gch"],
                           check=True)
            for header in headers:
                precompiled = ["-include", geometry] if includes_geometry(root, header) else []
                run = subprocess.run([*command, *precompiled, "-fsyntax-only", "-x", "c++", "-"],
                                     input=f'#include "{header}"\n#include "{header}"\n', text=True,
                                     check=False)
                if run.returncode != 0:
                    wrong.append(f"{compiler}: {header}")
    print("\n".join([*wrong, f"{len(headers)} headers by {len(sys.argv) - 4} compilers, "
                             f"{len(wrong)} failures"]))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
