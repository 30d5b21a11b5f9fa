#!/bin/sh
# SPDX-License-Identifier: MIT
# pybind11 2.10.3 (Debian pybind11-dev 2.10.3-1, python3-numpy 1:1.24.2-1+deb12u1): an argument of type
# py::array_t<int> takes numbers that are not whole or do not fit, and changes them, where an argument of
# type int or std::vector<int> refuses them.
#
# Expected: f([0.9]) and f(numpy.array([2**32 + 1])) are a TypeError, as they are for a std::vector<int>.
# Seen: the array holds 0 and 1. The default flag `forcecast` casts as astype() does, without a check.
# Flinch: bindings/python takes indices as an array of any whole numbers, and checks each.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q pybind11-dev=2.10.3-1 python3-numpy=1:1.24.2-1+deb12u1 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >casts.cpp <<'CPP'
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
PYBIND11_MODULE(casts, m) {
  m.def("array", [](pybind11::array_t<int> a) { return a.at(0); });
  m.def("vector", [](std::vector<int> v) { return v.at(0); });
}
CPP
g++ -shared -fPIC -O0 -I usr/include -I /usr/include/python3.11 casts.cpp -o casts.so
seen=$(PYTHONPATH=$folder:$folder/usr/lib/python3/dist-packages /usr/bin/python3 - <<'PYTHON'
import numpy
import casts

def call(function, value):
    try:
        return str(function(value))
    except TypeError:
        return "refused"

for value in ([0.9], numpy.array([2**32 + 1])):
    print("array_t", call(casts.array, value), "vector", call(casts.vector, value))
PYTHON
)
echo "$seen"
[ "$seen" = "array_t 0 vector refused
array_t 1 vector refused" ] || { echo "the behaviour has changed" >&2; exit 1; }
