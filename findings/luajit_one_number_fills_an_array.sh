#!/bin/sh
# SPDX-License-Identifier: MIT
# LuaJIT 2.1.0-beta3 (Debian luajit 2.1.0~beta3+git20220320+dfsg-4.1+deb12u1): of an array that is made from
# one number all elements are that number; of a struct only the first.
#
# Expected: as in C, {5} for double[3] is 5, 0, 0. So it is for {5, 0}, and for a struct of three doubles.
# Seen: {5} is 5, 5, 5, also for an array that is a field of a struct: a ball with velocity = {-20} flies
# aslant. A rotation {1}, meant as w, is four ones. An array of structs of which one is given is filled
# with it. LuaJIT's manual has this among the rules for initializers.
# Flinch: its Lua binding makes structs that way, and refuses a table that is shorter than its array.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=2.1.0~beta3+git20220320+dfsg-4.1+deb12u1
for package in luajit libluajit-5.1-2 libluajit-5.1-common; do
  apt-get -o APT::Sandbox::User=root download -q "$package=$version" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >arrays.lua <<'LUA'
local ffi = require("ffi")
ffi.cdef([[
typedef struct { double x, y, z; } point;
typedef struct { double velocity[3]; double radius; } ball;
]])

local function tell(name, x, y, z) print(("%s: %g %g %g"):format(name, x, y, z)) end
local function array(name, made) tell(name, made[0], made[1], made[2]) end

array("double[3] of {5}", ffi.new("double[3]", {5}))
array("double[3] of {5, 0}", ffi.new("double[3]", {5, 0}))
local point = ffi.new("point", {5})
tell("a struct of {5}", point.x, point.y, point.z)
array("a struct's velocity = {-20}", ffi.new("ball", {velocity = {-20}}).velocity)
local points = ffi.new("point[2]", {{1, 2, 3}})
tell("the second of two points of {{1, 2, 3}}", points[1].x, points[1].y, points[1].z)
LUA
LD_LIBRARY_PATH=usr/lib/x86_64-linux-gnu usr/bin/luajit arrays.lua | tee seen
cmp -s - seen <<'TEXT' || {
double[3] of {5}: 5 5 5
double[3] of {5, 0}: 5 0 0
a struct of {5}: 5 0 0
a struct's velocity = {-20}: -20 -20 -20
the second of two points of {{1, 2, 3}}: 1 2 3
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
