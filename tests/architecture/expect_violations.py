#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shows that a check can fail: runs it over a fixture with planted violations.

Usage: expect_violations.py EXPECTED COMMAND...

Passes when COMMAND exits with 1 and prints each line of the file EXPECTED, and no violation more.
"""

import subprocess
import sys
from pathlib import Path


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    expected = Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()
    run = subprocess.run([sys.executable, *sys.argv[2:]], capture_output=True, text=True, check=False)
    found = run.stdout.splitlines()[:-1]  # the last line is the count
    print(run.stdout + run.stderr)
    wrong = [f"not reported: {line}" for line in expected if line not in found]
    wrong += [f"not expected: {line}" for line in found if line not in expected]
    if run.returncode != 1:
        wrong.append(f"exit code {run.returncode} instead of 1")
    if not expected:
        wrong.append("expected nothing")
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
