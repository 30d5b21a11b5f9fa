#!/bin/sh
# SPDX-License-Identifier: MIT
# Faiss 1.7.3 (Debian python3-faiss 1.7.3-2+b1): the exact index finds the nearest neighbours of a query
# when it is asked alone, and others when it is asked with 19 more.
#
# Expected: IndexFlatL2 compares a query with all rows, so the answer to it does not depend on what else
# is asked in the same call.
# Seen: from 20 queries on, distances are computed as |x|^2 + |y|^2 - 2xy in single precision. Of rows
# around 1000, such as times in milliseconds or places in millimetres, 20 of 20 queries get their three
# neighbours one by one, and hardly one in a batch, whose distances are whole numbers or 0. Around 0
# both agree. So a test with one query passes, and the run over a file does not; subtracting the mean of
# the rows, or faiss.cvar.distance_compute_blas_threshold, mends it.
# Flinch: searches by FLANN, which sums squared differences.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-faiss=1.7.3-2+b1 python3-numpy libgomp1 libblas3 liblapack3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
cat >batch.py <<'PY'
import faiss
import numpy as np

def right(index, queries, nearest, size):
    answers = [index.search(queries[i:i + size], 3)[1] for i in range(0, 20, size)]
    return int((np.vstack(answers) == nearest).all(axis=1).sum())

random = np.random.default_rng(1)
for around in (0, 1000):
    rows = (around + random.normal(size=(1000, 8))).astype(np.float32)
    queries = (around + random.normal(size=(20, 8))).astype(np.float32)
    differences = queries[:, None].astype(float) - rows[None].astype(float)
    nearest = np.argsort((differences ** 2).sum(axis=2), axis=1)[:, :3]
    index = faiss.IndexFlatL2(8)
    index.add(rows)
    together = right(index, queries, nearest, 20)
    threshold = faiss.cvar.distance_compute_blas_threshold
    faiss.cvar.distance_compute_blas_threshold = 1000
    mended = right(index, queries, nearest, 20)
    faiss.cvar.distance_compute_blas_threshold = threshold
    print(f"around {around}: one by one {right(index, queries, nearest, 1)} of 20 right, together",
          "20" if together == 20 else "less than 5" if together < 5 else "some",
          f"and with a threshold of 1000 {mended}")
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
  /usr/bin/python3 batch.py | tee seen
cmp -s - seen <<'TEXT' || {
around 0: one by one 20 of 20 right, together 20 and with a threshold of 1000 20
around 1000: one by one 20 of 20 right, together less than 5 and with a threshold of 1000 20
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
