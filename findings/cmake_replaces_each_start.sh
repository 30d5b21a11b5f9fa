#!/bin/sh
# SPDX-License-Identifier: MIT
# CMake 3.25.1 (Debian cmake 3.25.1-1): string(REGEX REPLACE) with a "^" replaces at each new start that it
# makes, and takes both "../" off "../../sim/contact.h".
#
# Expected: "^" is the start of the text, so a prefix is replaced once, as by sed and by every library of
# regular expressions.
# Seen: after a match at the start the rest of the text counts as a text of its own, whose start matches
# again: "vv2" loses both letters, and REGEX MATCHALL "^." of abc gives three matches. The policy CMP0186 of CMake 4.1 changes it, for projects that ask for that version. A name that
# begins with its own prefix, or a relative path two levels up, becomes another one.
# Flinch: takes "flinch_" off the names of its targets by it; none has it twice.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in cmake=3.25.1-1 cmake-data=3.25.1-1 libarchive13 libjsoncpp25 librhash0 libuv1; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >starts.cmake <<'CMAKE'
foreach(text "../../sim/contact.h" "vv2" "flinch_flinch_motion")
  string(REGEX REPLACE "^(\\.\\./|v|flinch_)" "" rest "${text}")
  message("${text}: ${rest}")
endforeach()
string(REGEX MATCHALL "^." letters "abc")
message("abc: ${letters}")
CMAKE
LD_LIBRARY_PATH=usr/lib/x86_64-linux-gnu usr/bin/cmake -P starts.cmake 2>&1 | tee seen
for text in ../../sim/contact.h vv2; do echo "$text" | sed -E 's#^(\.\./|v)##'; done | tr '\n' ' ' >by_sed
[ "$(cat by_sed)" = "../sim/contact.h v2 " ]
cmp -s - seen <<'TEXT' || {
../../sim/contact.h: sim/contact.h
vv2: 2
flinch_flinch_motion: motion
abc: a;b;c
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
