#!/bin/sh
# SPDX-License-Identifier: MIT
# strace 6.1 (Debian strace 6.1-0.1): with --seccomp-bpf, injected signals are not delivered.
#
# Expected: `-e inject=fsync:signal=SIGKILL` kills the program at its fsync, with or without the
# option --seccomp-bpf, which is to change the speed alone.
# Seen: with --seccomp-bpf the program lives on and strace says nothing. Injected errors
# (`error=EIO`) work with both.
# Flinch: tests/e2e/crash_test.py traces without --seccomp-bpf, and expects that a kill kills.
set -eu
file=$(mktemp)
trap 'rm -f "$file"' EXIT
result() {
  strace -f "$@" -qq -o /dev/null -e trace=fsync -e inject=fsync:signal=SIGKILL sync "$file" \
    2>/dev/null && echo lives || echo killed
}
strace --version | head -n 1
plain=$(result)
filtered=$(result --seccomp-bpf)
echo "without --seccomp-bpf: $plain"
echo "with --seccomp-bpf: $filtered"
[ "$plain $filtered" = "killed lives" ] || { echo "the behaviour has changed" >&2; exit 1; }
