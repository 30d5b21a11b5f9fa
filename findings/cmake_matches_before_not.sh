#!/bin/sh
# SPDX-License-Identifier: MIT
# CMake 3.25.1 (Debian cmake 3.25.1-1): in if(), a MATCHES takes CMAKE_MATCH_1 away from a condition to
# its left.
#
# Expected: after string(REGEX MATCH "^-D([A-Z]+)=OFF$" ...) has found FAST, if(NOT CMAKE_MATCH_1 OR NOT
# x MATCHES y) is false where x matches y: the first condition is looked at first.
# Seen: it is true. if() works off all binary tests before it looks at NOT, and a MATCHES without groups
# empties CMAKE_MATCH_1. With the binary CMAKE_MATCH_1 STREQUAL "" in place of NOT, the order is that of
# reading, and it is false.
# Flinch: tests/install/check_vcpkg_port.cmake compares by STREQUAL.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q cmake=3.25.1-1 cmake-data=3.25.1-1 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >order.cmake <<'CMAKE'
set(text "option(FAST)")
string(REGEX MATCH "^-D([A-Z]+)=OFF$" all "-DFAST=OFF")
set(unary false)
if(NOT CMAKE_MATCH_1 OR NOT text MATCHES "option")
  set(unary true)
endif()
string(REGEX MATCH "^-D([A-Z]+)=OFF$" all "-DFAST=OFF")
set(binary false)
if(CMAKE_MATCH_1 STREQUAL "" OR NOT text MATCHES "option")
  set(binary true)
endif()
message("NOT CMAKE_MATCH_1 OR ...: ${unary}; CMAKE_MATCH_1 STREQUAL \"\" OR ...: ${binary}")
CMAKE
seen=$(usr/bin/cmake -P order.cmake 2>&1)
echo "$seen"
[ "$seen" = 'NOT CMAKE_MATCH_1 OR ...: true; CMAKE_MATCH_1 STREQUAL "" OR ...: false' ] ||
  { echo "the behaviour has changed" >&2; exit 1; }
