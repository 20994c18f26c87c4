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
failed=0
$MAKE --no-print-directory -f "$SRC/Makefile" "O=$work" float

# prints_by COMPILER PROGRAM: what the program prints, in found.txt.
prints_by()
{
    rm -f "$work/found.txt"
    # shellcheck disable=SC2086
    $1 -I"$SRC/include" -I"$SRC/lib" -I"$work/float" "$here/$2" \
        "$SRC"/lib/*.c "$SRC"/lib/real/*.c "$work"/float/*.c -o "$work/program" -lm &&
        "$work/program" >"$work/found.txt"
}

if test "${1:-}" = update; then
    cc="cc -std=c99 -O2 -ffp-contract=off"
    prints_by "$cc" pin.c
    echo "lib/selftest.c has to pin $(cat "$work/found.txt")"
    prints_by "$cc" pin_float.c
    echo "lib/float/selftest.c has to pin $(cat "$work/found.txt")"
    prints_by "$cc" hash.c
    cp "$work/found.txt" "$here/expected.txt"
    tail -1 "$here/expected.txt"
    exit
fi

while read -r compiler; do
    if prints_by "$compiler" hash.c && cmp -s "$work/found.txt" "$here/expected.txt"
    then
        result=same
    else
        result=DIFFERENT
        failed=1
    fi
    printf '%-9s  %s\n' $result "$compiler"
    test $result = same || diff "$here/expected.txt" "$work/found.txt" || :
done <<END
gcc -std=c99 -ffp-contract=off -O0
gcc -std=c99 -ffp-contract=off -O2
gcc -std=c99 -ffp-contract=off -O3
gcc -std=c99 -ffp-contract=off -O3 -march=native
gcc -std=c99 -ffp-contract=off -O2 -flto
gcc -std=gnu11 -O3 -march=native
clang -std=c99 -ffp-contract=off -O0
clang -std=c99 -ffp-contract=off -O3 -march=native
clang -std=gnu11 -O3 -march=native
tcc -std=c99
musl-gcc -std=c99 -ffp-contract=off -O2 -static
END

tail -1 "$here/expected.txt"
exit $failed
