#!/bin/sh
# SPDX-License-Identifier: MIT
# Every compiler, level of optimisation and C library must move the coins by
# the same bits, those of expected.txt.  The sources are compiled as a user
# does who drops them into a project; the two gnu11 lines, whose default is to
# contract, show that the guards in the sources do without the flag.
#     hash.sh [update]     from `make repro`: MAKE SRC OUT
set -eu
here=$SRC/tests/repro
work=$OUT/repro
mkdir -p "$work"
. "$SRC/tests/at_once.sh"

# prints_by NAME COMPILER PROGRAM: what the program prints, in NAME.txt.
prints_by()
{
    rm -f "$work/$1.txt"
    # shellcheck disable=SC2086
    $2 -I"$SRC/include" "$here/$3" "$SRC"/lib/*/*.c -o "$work/$1" -lm &&
        "$work/$1" >"$work/$1.txt"
}

if test "${1:-}" = update; then
    cc="cc -std=c99 -O2 -ffp-contract=off"
    prints_by pin "$cc" pin.c
    echo "lib/about/selftest.c has to pin $(cat "$work/pin.txt")"
    prints_by pin "$cc -DFLOATS" pin.c
    echo "lib/float/coinf_selftest.c has to pin $(cat "$work/pin.txt")"
    prints_by pin "$cc" hash.c
    cp "$work/pin.txt" "$here/expected.txt"
    tail -1 "$here/expected.txt"
    exit
fi

# same NUMBER COMPILER
same()
{
    if prints_by "$1" "$2" hash.c && cmp -s "$here/expected.txt" "$work/$1.txt"
    then
        echo "same       $2"
    else
        echo "DIFFERENT  $2"
        diff "$here/expected.txt" "$work/$1.txt"
        return 1
    fi
}

at_once same <<END
gcc -std=c99 -ffp-contract=off -O0
tcc -std=c99
gcc -std=c99 -ffp-contract=off -O2
gcc -std=c99 -ffp-contract=off -O3
gcc -std=c99 -ffp-contract=off -O3 -march=native
gcc -std=c99 -ffp-contract=off -O2 -flto
gcc -std=gnu11 -O3 -march=native
musl-gcc -std=c99 -ffp-contract=off -O2 -static
clang -std=c99 -ffp-contract=off -O3 -march=native
clang -std=gnu11 -O3 -march=native
clang -std=c99 -ffp-contract=off -O0
END
tail -1 "$here/expected.txt"
