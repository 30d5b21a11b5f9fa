#!/bin/sh
# SPDX-License-Identifier: MIT
# LuaJIT 2.1.0-beta3 (Debian luajit 2.1.0~beta3+git20220320+dfsg-4.1+deb12u1): a library of ffi.load is
# closed before the finalizers of ffi.gc that call it.
#
# Expected: what ffi.gc(object, C.free_it) has made is freed, and then the library of C is closed: the
# finalizer is a function of the library, and needs it.
# Seen: where both become garbage at once, as at the end of a script that fails, the library is closed
# first, and the finalizer calls into nothing. Here dlclose() only prints, so that the order can be seen.
# Flinch: bindings/lua/flinch.lua holds every library that it has loaded for as long as Lua runs.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version='2.1.0~beta3+git20220320+dfsg-4.1+deb12u1'
apt-get -o APT::Sandbox::User=root download -q luajit="$version" libluajit-5.1-2="$version" \
  libluajit-5.1-common="$version" >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >object.c <<'C'
#include <stdio.h>
void free_it(void* object) { (void)object; puts("finalizer"); fflush(stdout); }
C
cat >dlclose.c <<'C'
#include <stdio.h>
int dlclose(void* library) { (void)library; puts("library closed"); fflush(stdout); return 0; }
C
cc -shared -fPIC object.c -o libobject.so
cc -shared -fPIC dlclose.c -o dlclose.so
cat >order.lua <<'LUA'
local ffi = require("ffi")
ffi.cdef("void free_it(void* object);")
do
  local C = ffi.load("./libobject.so")
  local object = ffi.gc(ffi.new("int[1]"), C.free_it)
end
collectgarbage()
collectgarbage()
LUA
seen=$(LD_LIBRARY_PATH=$folder/usr/lib/x86_64-linux-gnu LD_PRELOAD=$folder/dlclose.so usr/bin/luajit order.lua |
  head -n 2 | tr '\n' ',')
echo "$seen"
[ "$seen" = 'library closed,finalizer,' ] || { echo "the behaviour has changed" >&2; exit 1; }
