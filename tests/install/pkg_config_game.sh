#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds a game in C with the flags that pkg-config gives for the installed package, and runs it.
# Usage: pkg_config_game.sh COMPILER LIBDIR GAME SELECTOR [FLAG...]
set -eu
compiler=$1 libdir=$2 game=$3 selector=$4
shift 4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export PKG_CONFIG_PATH="$libdir/pkgconfig"
# shellcheck disable=SC2046 # splits what pkg-config prints into words
"$compiler" -std=c99 -Wall -Werror "$game" -o "$folder/game" "$@" $(pkg-config --cflags --libs flinch)
LD_LIBRARY_PATH=$libdir "$folder/game" "$selector"
