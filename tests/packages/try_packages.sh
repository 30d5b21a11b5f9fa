# SPDX-License-Identifier: MIT
# What scripts/package --test runs on a new Debian, where /packages has the packages, a game in C and a
# checkout.
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
cd /packages
apt_get() { apt-get -q -y -o APT::Install-Recommends=0 "$@" >/tmp/apt.log 2>&1 || { tail -n 20 /tmp/apt.log; exit 1; }; }
say() { printf '\n== %s\n' "$*"; }
fail() { echo "try_packages: $*" >&2; exit 1; }
# A failure in a list with && or before a pipe would go unseen, so these run one command each.
quietly() { "$@" >/tmp/quiet.log 2>&1 || { tail -n 20 /tmp/quiet.log; fail "$*"; }; }
last_lines() { count=$1; shift; "$@" >/tmp/last.log || fail "$*"; tail -n "$count" /tmp/last.log; }
build() { quietly cmake -G Ninja -S "$1" -B "$2" -DCMAKE_BUILD_TYPE=Release ${3-}; quietly cmake --build "$2"; }
# Makes a selector from nothing with the program at $1, and a response.
try_program() {
  rm -rf /tmp/out && mkdir /tmp/out
  "$1" author --out /tmp/out/a.flinchlib
  "$1" simulate /tmp/out/a.flinchlib --out /tmp/out/a.flinchobs -n 40 2>/dev/null
  "$1" train /tmp/out/a.flinchobs --model knn_cost --out /tmp/out/a.flinch
  "$1" select /tmp/out/a.flinch --azimuth 40 --target head
  "$1" respond /tmp/out/a.flinch --azimuth 40 --target head --out /tmp/out/a.glb
}
apt_get update

say 'the program, by its package'
apt_get install ./flinch_*.deb
dpkg -s flinch | grep -E '^(Version|Depends)'
try_program flinch
quietly flinch compare /tmp/out/a.flinchobs --models knn --report /tmp/out/report
test -s /tmp/out/report/report.html
flinch view /tmp/out/a.flinch --out /tmp/out/page.html
test -s /usr/share/man/man1/flinch-simulate.1.gz || test -s /usr/share/man/man1/flinch-simulate.1
bash -c '. /usr/share/bash-completion/completions/flinch; COMP_WORDS=(flinch tra); COMP_CWORD=1; _flinch
  test "${COMPREPLY[*]}" = "train train-realism"'
grep -q 'Mozilla Public License' /usr/share/doc/flinch/copyright
if dpkg -s libflinch-dev >/dev/null 2>&1; then fail 'flinch brought libflinch-dev'; fi
dpkg-query -W -f '${Depends}' flinch | grep -q libspdlog || fail 'flinch does not depend on spdlog'

say 'a game in C, by libflinch-dev, pkg-config and CMake'
apt_get install ./libflinch*.deb gcc libc6-dev pkg-config
dpkg -s libflinch0.1 | grep -E '^(Version|Depends)'
cc game_loop.c $(pkg-config --cflags --libs flinch) -o /tmp/game
last_lines 3 /tmp/game /tmp/out/a.flinch
apt_get install cmake g++ ninja-build
mkdir /tmp/c
cat >/tmp/c/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(game C CXX)
find_package(flinch REQUIRED)
add_executable(game /packages/game_loop.c)
target_link_libraries(game PRIVATE flinch::flinch_static)
add_executable(cpp /packages/checkout/examples/game_loop.cpp)
target_link_libraries(cpp PRIVATE flinch::runtime)
CMAKE
build /tmp/c /tmp/c/build
last_lines 1 /tmp/c/build/game /tmp/out/a.flinch
last_lines 1 /tmp/c/build/cpp /tmp/out/a.flinch

say 'the same from the .tar.gz, and no package left'
apt_get purge flinch libflinch0.1 libflinch-dev
if [ -e /usr/bin/flinch ]; then fail 'purging left the program'; fi
mkdir /tmp/tar && tar -xzf flinch-*.tar.gz --strip-components=1 -C /tmp/tar
flinch=$(find /tmp/tar -path '*/bin/flinch')
try_program "$flinch"
export PKG_CONFIG_PATH=$(dirname "$(find /tmp/tar -name flinch.pc)")
cc game_loop.c $(pkg-config --cflags --libs --static flinch) -o /tmp/game2
last_lines 1 env LD_LIBRARY_PATH="$(dirname "$PKG_CONFIG_PATH")" /tmp/game2 /tmp/out/a.flinch

say 'a game that fetches Flinch by CMake'
apt_get install libeigen3-dev libflatbuffers-dev flatbuffers-compiler flatbuffers-compiler-dev python3
build fetched /tmp/fetched -DFLINCH_CHECKOUT=/packages/checkout
last_lines 1 /tmp/fetched/game /tmp/out/a.flinch
