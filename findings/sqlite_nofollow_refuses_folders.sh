#!/bin/sh
# SPDX-License-Identifier: MIT
# SQLite 3.40.1 (Debian libsqlite3-dev 3.40.1-2+deb12u2): SQLITE_OPEN_NOFOLLOW refuses a database
# whose folder is reached through a link.
#
# Expected, from O_NOFOLLOW of open(2): only a link at the last place of the path is refused.
# Seen: a link anywhere in the path gives SQLITE_CANTOPEN_SYMLINK (1550), so the flag breaks every
# path below a linked folder, such as a home or a temporary folder that is a link.
# Flinch: plain_file_name() in train/store/sqlite.cpp follows the folder's links before.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir real
ln -s real linked
cat >nofollow.c <<'C'
#include <sqlite3.h>
#include <stdio.h>

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    sqlite3* database = 0;
    const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOFOLLOW;
    sqlite3_open_v2(argv[i], &database, flags, 0);
    printf("%d ", sqlite3_extended_errcode(database));
    sqlite3_close(database);
  }
  printf("%s\n", sqlite3_libversion());
}
C
gcc nofollow.c -lsqlite3 -o nofollow
seen=$(./nofollow "$(pwd -P)/real/a" "$(pwd -P)/linked/a")
echo "in a folder, in a linked folder, version: $seen"
case "$seen" in
  "0 1550 "*) ;;
  *) echo "the behaviour has changed" >&2; exit 1 ;;
esac
