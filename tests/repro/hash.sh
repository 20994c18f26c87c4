#!/bin/sh
# SPDX-License-Identifier: MIT
# Every compiler, level of optimisation and C library must move the coins by
# the same bits, those of expected.txt.  The sources are compiled as a user
# does who drops them into a project.  fused.sh looks at the highest levels, and
# `make consumers` at what CMake builds.
#     hash.sh [update]     from `make repro`: MAKE CC SRC OUT
set -eu
here=$SRC/tests/repro
work=$OUT/repro
mkdir -p "$work"
. "$SRC/tests/at_once.sh"

# prints_by NAME COMPILER PROGRAM LIBRARY...: what the program prints, in NAME.txt.
prints_by()
{
    name=$1 compiler=$2 program=$3
    shift 3
    rm -f "$work/$name.txt"
    # shellcheck disable=SC2086
    $compiler -I"$SRC/include" "$here/$program" "$@" -o "$work/$name" -lm &&
        "$work/$name" >"$work/$name.txt"
}

if test "${1:-}" = update; then
    cc="cc -std=c99 -O2 -ffp-contract=off"
    prints_by pin "$cc" pin.c "$SRC"/lib/*/*.c
    echo "lib/about/selftest.c has to pin $(cat "$work/pin.txt")"
    prints_by pin "$cc -DFLOATS" pin.c "$SRC"/lib/*/*.c
    echo "lib/float/coinf_selftest.c has to pin $(cat "$work/pin.txt")"
    prints_by pin "$cc" hash.c "$SRC"/lib/*/*.c
    cp "$work/pin.txt" "$here/expected.txt"
    tail -1 "$here/expected.txt"
    exit
fi

# same NUMBER COMPILER [LIBRARY]
same()
{
    number=$1 line=$2
    shift 2
    test $# = 1 || set -- "$SRC"/lib/*/*.c
    if prints_by "$number" "$line" hash.c "$@" &&
        cmp -s "$here/expected.txt" "$work/$number.txt"
    then
        echo "same       $line"
    else
        echo "DIFFERENT  $line"
        diff "$here/expected.txt" "$work/$number.txt"
        return 1
    fi
}

same make "$CC" "$OUT/librollcoin.a"
at_once same <<END
gcc -std=c99 -ffp-contract=off -O0
gcc -std=c99 -ffp-contract=off -O2 -flto
clang -std=c99 -ffp-contract=off -O0
musl-gcc -std=c99 -ffp-contract=off -O2 -static
tcc -std=c99
END
tail -1 "$here/expected.txt"
