#!/bin/sh
# SPDX-License-Identifier: MIT
# coin_advance() of this tree beside that of an older revision, in one process:
#     against.sh REVISION portable|native [scenes|coins|frames|until|moves]
# Needs the git history, and objcopy.  Works in build/against.
set -eu
revision=$1 build=$2
src=$(cd "$(dirname "$0")/../../.." && pwd)
work=$src/build/against/$build
flags="-O2 -ffp-contract=off -fno-tree-vectorize"
test "$build" = portable || flags="$flags -march=native"
rm -rf "$work"
mkdir -p "$work/old" "$work/new"
git -C "$src" archive "$revision" include lib | tar -x -C "$work/old"

# objects TREE: those of its library, in doubles.
objects()
{
    for c in "$1"/lib/*.c "$1"/lib/*/*.c; do
        case $c in */float/* | *'*'*) continue ;; esac
        # shellcheck disable=SC2086
        gcc -std=c99 $flags -I"$1/include" -I"$1/lib" -c "$c" \
            -o "$2/$(basename "$c" .c).o"
    done
}

objects "$work/old" "$work/old"
objects "$src" "$work/new"
ld -r -o "$work/old.o" "$work/old"/*.o
objcopy --prefix-symbols=old_ "$work/old.o"
for name in sqrt log memcpy memset _GLOBAL_OFFSET_TABLE_; do
    objcopy --redefine-sym "old_$name=$name" "$work/old.o"
done
# shellcheck disable=SC2086
gcc -std=c11 $flags -D_POSIX_C_SOURCE=200809L -I"$src/include" \
    -DBENCH_DATA="\"$src/tests/reference\"" -o "$work/against" \
    "$src/tests/studies/bench/against.c" "$src/tests/studies/bench/scene.c" \
    "$src/tests/studies/bench/textbook.c" "$work/new"/*.o "$work/old.o" -lm
for what in ${3:-scenes coins frames until moves}; do
    "$work/against" $what
done
