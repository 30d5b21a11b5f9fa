#!/bin/sh
# SPDX-License-Identifier: MIT
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2): with the same seed, the bootstrap interval of two samples
# depends on how many resamples are computed at a time.
#
# Expected: batch is for memory, as the manual says, so with one random_state each batch gives the same
# interval, as it does for one sample.
# Seen: for each batch the resamples of the first sample are drawn and then those of the second, so
# the draws of both samples change places with the size of the batch. Who splits the work because
# the samples have grown, or on a smaller machine, gets another interval from the same seed: here its
# lower end is 0.130, 0.116, 0.134 or 0.129.
# Flinch: draws by seed and counter, so an interval does not depend on threads or memory.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-scipy=1.10.1-2 python3-numpy=1:1.24.2-1+deb12u1 python3-decorator liblbfgsb0 \
  libblas3 liblapack3 libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >interval.py <<'PY'
import numpy
from scipy.stats import bootstrap

draw = numpy.random.default_rng(1)
first, second = draw.normal(0.5, 1, 30), draw.normal(0, 1, 40)


def difference(a, b, axis=-1):
    return a.mean(axis) - b.mean(axis)


for batch in None, 1, 10, 100:
    one, two = (
        bootstrap(samples, statistic, n_resamples=999, batch=batch, random_state=1,
                  method="percentile").confidence_interval
        for samples, statistic in [((first,), numpy.mean), ((first, second), difference)])
    print(f"batch {batch}: one sample {one.low:.3f} to {one.high:.3f},",
          f"two samples {two.low:.3f} to {two.high:.3f}")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 interval.py | tee seen
one='one sample 0.136 to 0.706, two samples'
printf '%s\n' "batch None: $one 0.130 to 0.897" "batch 1: $one 0.116 to 0.930" \
  "batch 10: $one 0.134 to 0.907" "batch 100: $one 0.129 to 0.904" | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
