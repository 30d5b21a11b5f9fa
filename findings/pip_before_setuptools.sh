#!/bin/sh
# SPDX-License-Identifier: MIT
# setuptools 66.1.1 (Debian python3-setuptools 66.1.1-1+deb12u2) and pip 23.0.1 (Debian python3-pip
# 23.0.1+dfsg-1): a program that imports pip cannot import setuptools after it.
#
# Expected: both imports succeed, in either order, as a check of what is installed needs them.
# Seen: setuptools first, then pip: both are there. pip first: an AssertionError that names a file of the
# standard library's distutils. setuptools' path entry hooks the import of pip and from then on leaves
# distutils to the standard library, which setuptools then refuses.
# Flinch: tests/python/pip_test.py looks for both with importlib.util.find_spec and imports neither.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q python3-pip=23.0.1+dfsg-1 \
  python3-setuptools=66.1.1-1+deb12u2 python3-pkg-resources=66.1.1-1+deb12u2 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
try() {
  /usr/bin/python3 -I -S -c "
import site
site.addsitedir('$folder/usr/lib/python3/dist-packages')
try:
    import $1
    import $2
    print('both')
except AssertionError as error:
    print('AssertionError')"
}
seen="setuptools, pip: $(try setuptools pip); pip, setuptools: $(try pip setuptools)"
echo "$seen"
[ "$seen" = 'setuptools, pip: both; pip, setuptools: AssertionError' ] ||
  { echo "the behaviour has changed" >&2; exit 1; }
