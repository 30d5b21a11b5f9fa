#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails if a program lacks the protections that files of strangers call for.

Usage: check_hardening.py PROGRAM

It is position-independent, its stack is not executable, what the loader has filled in is read-only,
functions with buffers check the stack when they return, and copies into buffers check their size.
"""

import re
import subprocess
import sys

# What `readelf` prints of a program that has each.
PROTECTIONS = {
    "is not position-independent": r"FLAGS_1\).*\bPIE\b",
    "has an executable stack": r"GNU_STACK +(0x\w+ +){5}RW ",
    "has no read-only relocations": r"\bGNU_RELRO\b",
    "binds functions when they are called, not when it starts": r"FLAGS_1\).*\bNOW\b",
    "has no stack protector": r"\b__stack_chk_fail\b",
    "does not check the sizes of buffers": r"\b__(mem|str|read|v?s?n?printf)\w*_chk\b",
}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    described = subprocess.run(
        ["readelf", "--program-headers", "--dynamic", "--dyn-syms", "--wide", sys.argv[1]],
        check=True, capture_output=True, text=True).stdout
    violations = [what for what, shown in PROTECTIONS.items() if not re.search(shown, described)]
    print("\n".join(violations))
    print(f"{len(PROTECTIONS)} protections, {len(violations)} violations")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
