#!/bin/sh
# SPDX-License-Identifier: MIT
# pandas 1.5.3 (Debian python3-pandas 1.5.3+dfsg-2): read_csv reads about half of all doubles with
# another last bit.
#
# Expected: a table that was written with as many digits as a double needs is read back as it was,
# as Python's float() and csv module do with the same text.
# Seen: the fast parser multiplies digits by powers of ten and rounds more than once. Of 20000 numbers
# with their shortest exact digits, 10330 come back as a neighbour. float_precision="high" is that
# default and not better; "round_trip" is exact. So two tables that are equal as text and as numbers
# give other results after read_csv than after another reader.
# Flinch: writes its tables with digits that read back exactly; who checks them bit by bit in pandas
# needs float_precision="round_trip".
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-pandas=1.5.3+dfsg-2 python3-pandas-lib=1.5.3+dfsg-2 python3-numpy \
  python3-dateutil python3-tz python3-six libblas3 liblapack3 libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >read.py <<'PY'
import csv
import io
import random

import pandas

draw = random.Random(1)
numbers = [draw.uniform(-1, 1) * 10 ** draw.randint(-3, 3) for _ in range(20000)]
text = "x\n" + "".join(f"{number!r}\n" for number in numbers)


def other(read):
    return sum(a != b for a, b in zip(read, numbers, strict=True))


print("csv and float():", other(float(row["x"]) for row in csv.DictReader(io.StringIO(text))))
for precision in (None, "high", "round_trip"):
    table = pandas.read_csv(io.StringIO(text), float_precision=precision)
    print(f"read_csv, float_precision {precision}:", other(table["x"]))
PY
libraries=$(dirname "$(find usr/lib -name 'libgfortran.so.5' | head -n 1)")
PYTHONPATH=usr/lib/python3/dist-packages \
  LD_LIBRARY_PATH="$libraries:$libraries/blas:$libraries/lapack" python3 read.py | tee seen
printf '%s\n' 'csv and float(): 0' 'read_csv, float_precision None: 10330' \
  'read_csv, float_precision high: 10330' 'read_csv, float_precision round_trip: 0' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
