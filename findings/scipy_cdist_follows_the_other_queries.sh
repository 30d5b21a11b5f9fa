#!/bin/sh
# SPDX-License-Identifier: MIT
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2): the nearest clip of a query by cdist with the metric
# "seuclidean" or "mahalanobis" depends on the other queries of the call.
#
# Expected: the distance between a query and a clip is a matter of these two, or of the clips, which are
# the rows that are known.
# Seen: the variances that the differences are divided by are those of queries and clips together. A
# query between two clips is nearest to the second when it is asked alone, and to the first with another
# query far off in the first feature. Who evaluates a selector on a table gets other answers than the
# selector gives for one row after the other. With V, or VI, of the clips passed both agree.
# Flinch: scales by the training rows alone, once.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-scipy=1.10.1-2 python3-numpy python3-decorator libblas3 liblapack3 libgfortran5 \
  liblbfgsb0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
cat >nearest.py <<'PY'
import numpy as np
from scipy.spatial.distance import cdist

clips = np.array([[0.0, 0.0], [1.0, 0.6], [0.0, 1.0], [1.0, 1.4]])
query, other = [0.7, 0.2], [9.0, 0.5]
inverse = np.linalg.inv(np.cov(clips.T))
for metric, of_clips in (("seuclidean", {"V": clips.var(axis=0, ddof=1)}), ("mahalanobis", {"VI": inverse})):
    for name, options in (("", {}), (" with the clips' own", of_clips)):
        answers = [1 + int(cdist(rows, clips, metric, **options)[0].argmin())
                   for rows in ([query], [query, other])]
        print(f"{metric}{name}: alone clip {answers[0]}, with another query clip {answers[1]}")
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
  /usr/bin/python3 nearest.py | tee seen
cmp -s - seen <<'TEXT' || {
seuclidean: alone clip 2, with another query clip 1
seuclidean with the clips' own: alone clip 2, with another query clip 2
mahalanobis: alone clip 2, with another query clip 1
mahalanobis with the clips' own: alone clip 2, with another query clip 2
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
