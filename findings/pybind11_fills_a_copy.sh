#!/bin/sh
# SPDX-License-Identifier: MIT
# pybind11 2.10.3 (Debian pybind11-dev 2.10.3-1) and NumPy 1.24.2: a function that fills an array of doubles
# fills a copy where it is given floats, or every second frame of doubles.
#
# Expected: a parameter array_t<double> takes arrays of doubles and refuses others, or else works on what it
# was given: what it writes is in the caller's array.
# Seen: an array of floats is converted into a new array, the function fills that, and the caller's stays
# as it was, with no error. By array_t<double, c_style | forcecast> so does each array that is not
# contiguous, such as every second frame of doubles. With .noconvert() both are refused.
# Flinch: bindings/python returns new arrays and fills none of the caller's.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q pybind11-dev=2.10.3-1 python3-numpy=1:1.24.2-1+deb12u1 \
  >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >fills.cpp <<'CPP'
#include <pybind11/numpy.h>

namespace py = pybind11;
using Contiguous = py::array_t<double, py::array::c_style | py::array::forcecast>;

template <class Array>
void ones(Array out) {
  for (py::ssize_t i = 0; i < out.size(); ++i) out.mutable_at(i) = 1;
}

PYBIND11_MODULE(fills, m) {
  m.def("plain", ones<py::array_t<double>>);
  m.def("contiguous", ones<Contiguous>);
  m.def("strict", ones<Contiguous>, py::arg().noconvert());
}
CPP
g++ -std=c++17 -shared -fPIC -O0 -w -I usr/include -I /usr/include/python3.11 fills.cpp -o fills.so
cat >call.py <<'PY'
import numpy
import fills

for name in "plain", "contiguous", "strict":
    for kind, array in (("doubles", numpy.zeros(4)), ("floats", numpy.zeros(4, numpy.float32)),
                        ("every second double", numpy.zeros(8)[::2])):
        try:
            getattr(fills, name)(array)
            print(f"{name}, {kind}: {array.sum():.0f} of 4 filled")
        except TypeError:
            print(f"{name}, {kind}: refused")
PY
PYTHONPATH=$folder:$folder/usr/lib/python3/dist-packages /usr/bin/python3 call.py | tee seen
cmp -s - seen <<'TEXT' || {
plain, doubles: 4 of 4 filled
plain, floats: 0 of 4 filled
plain, every second double: 4 of 4 filled
contiguous, doubles: 4 of 4 filled
contiguous, floats: 0 of 4 filled
contiguous, every second double: 0 of 4 filled
strict, doubles: 4 of 4 filled
strict, floats: refused
strict, every second double: refused
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
