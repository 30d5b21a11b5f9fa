#!/bin/sh
# SPDX-License-Identifier: MIT
# scikit-learn 1.2.1 (Debian python3-sklearn 1.2.1+dfsg-1): a table that dump_svmlight_file() writes and
# load_svmlight_file() reads has its columns moved by one where the first is zero, and other last bits.
#
# Expected: two functions of one module, called with their defaults, give the table back.
# Seen: the writer counts columns from 0 and leaves zeros out; the reader takes files that nowhere name the
# column 0 for ones that count from 1. A test set in which the first feature is 0 throughout comes back
# with each feature in the place of the one before, also with n_features=4 given, and a model that was
# fitted on the training set takes speed for angle. And %.16g changes a quarter of all doubles. With
# zero_based=True in both the columns are right.
# Flinch: its .libsvm files count from 1, have each feature in each row, and all digits.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-sklearn=1.2.1+dfsg-1 python3-sklearn-lib=1.2.1+dfsg-1 python3-scipy \
  python3-numpy python3-joblib python3-threadpoolctl python3-decorator liblbfgsb0 libblas3 liblapack3 \
  libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >round_trip.py <<'PY'
import numpy
from sklearn.datasets import dump_svmlight_file, load_svmlight_file

draw = numpy.random.default_rng(1)
table = draw.random((1000, 4))
label = numpy.arange(1000) % 2
dump_svmlight_file(table, label, "table.libsvm")
read = load_svmlight_file("table.libsvm")[0].toarray()
print(f"{(read != table).sum()} of 4000 numbers are others, by at most {abs(read - table).max():.0e}")
table[:, 0] = 0
dump_svmlight_file(table, label, "table.libsvm")
for options in {}, {"n_features": 4}, {"zero_based": True}:
    read = load_svmlight_file("table.libsvm", **options)[0].toarray()
    print(f"first column zero, {options or 'defaults'}: {read.shape[1]} columns, the first row "
          f"{' '.join(f'{x:.2f}' for x in read[0])} of {' '.join(f'{x:.2f}' for x in table[0])}")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 round_trip.py | tee seen
cmp -s - seen <<'TEXT' || {
1000 of 4000 numbers are others, by at most 6e-17
first column zero, defaults: 3 columns, the first row 0.95 0.14 0.95 of 0.00 0.95 0.14 0.95
first column zero, {'n_features': 4}: 4 columns, the first row 0.95 0.14 0.95 0.00 of 0.00 0.95 0.14 0.95
first column zero, {'zero_based': True}: 4 columns, the first row 0.00 0.95 0.14 0.95 of 0.00 0.95 0.14 0.95
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
