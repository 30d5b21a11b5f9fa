#!/bin/sh
# SPDX-License-Identifier: MIT
# toml 0.10.2 (Python; Debian python3-toml 0.10.2-1): a number that NumPy has made is written as text, and of
# some arrays that it writes it reads none.
#
# Expected: numpy.float64 is a float of Python, too, and toml.dumps() writes 0.1 as 0.1, or refuses it, as
# tomli-w 1.0.0 does.
# Seen: numbers of NumPy come out in quotes, and an array of them as an array of texts, with no error: the
# reader of the file gets "0.1", or its default. An array of 1 and 2.5 is written as TOML 1.0 allows, and
# toml.loads() refuses it. A control character in a text loses its backslash and becomes x01.
# toml.TomlNumpyEncoder() writes the numbers of NumPy as numbers.
# Flinch: reads by toml++, which takes mixed arrays, and names the line where a number is text. Who writes
# its files by toml converts by float() first.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-toml=0.10.2-1 python3-tomli python3-tomli-w python3-numpy libblas3 liblapack3 \
  libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >parameters.py <<'PY'
import numpy
import tomli
import tomli_w
import toml

for value in 0.1, numpy.float64(0.1), numpy.array([0.5, 1.0]).mean(), numpy.array([0.5, 1.0]), [1, 2.5], \
        "a\x01b":
    text = toml.dumps({"x": value})
    try:
        own = repr(toml.loads(text)["x"])
    except toml.TomlDecodeError:
        own = "refused"
    print(f"{type(value).__name__}: {text.strip()}, read as {tomli.loads(text)['x']!r} by tomli, "
          f"{own} by toml")
try:
    print("tomli-w:", tomli_w.dumps({"x": numpy.array([0.5])}).strip())
except TypeError:
    print("tomli-w: an array of NumPy is refused")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 parameters.py | tee seen
cmp -s - seen <<'TEXT' || {
float: x = 0.1, read as 0.1 by tomli, 0.1 by toml
float64: x = "0.1", read as '0.1' by tomli, '0.1' by toml
float64: x = "0.75", read as '0.75' by tomli, '0.75' by toml
ndarray: x = [ "0.5", "1.0",], read as ['0.5', '1.0'] by tomli, ['0.5', '1.0'] by toml
list: x = [ 1, 2.5,], read as [1, 2.5] by tomli, refused by toml
str: x = "ax01b", read as 'ax01b' by tomli, 'ax01b' by toml
tomli-w: an array of NumPy is refused
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
