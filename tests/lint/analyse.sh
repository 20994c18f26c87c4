#!/bin/sh
# SPDX-License-Identifier: MIT
# The sources are clean under cppcheck, gcc's analyzer and clang's warnings,
# and everything compiles without a warning by both compilers.
# From `make lint`: MAKE SRC OUT.
set -eu
work=$OUT/lint
mkdir -p "$work"

status=0

try() { "$@" || status=1; }

# badBitmaskCheck: COIN_VERSION_MAJOR << 16 may well be 0.
try cppcheck --quiet --std=c99 --error-exitcode=1 --inline-suppr \
    --enable=warning,style,performance,portability \
    --suppress=missingIncludeSystem --suppress=badBitmaskCheck \
    -DCOIN_API= -I"$SRC/include" -I"$SRC/lib" "$SRC"/lib/*.c "$SRC"/lib/real/*.c \
    "$OUT"/float/*.c

# Off for clang: float-equal, as NaN and exact zeros are compared on purpose;
# double-promotion, as NAN and INFINITY are floats, and gcc keeps watch;
# documentation, which does not know "@param x,z"; declaration-after-statement
# and padded, which are no faults.
off="-Wno-float-equal -Wno-double-promotion -Wno-documentation
    -Wno-declaration-after-statement -Wno-padded"
own="-std=c99 -O2 -ffp-contract=off -Werror -I$SRC/include -I$SRC/lib"
for file in "$SRC"/lib/*.c "$SRC"/lib/real/*.c "$OUT"/float/*.c; do
    # shellcheck disable=SC2086
    try gcc $own -Wall -Wextra -Wdouble-promotion -fanalyzer \
        -c "$file" -o "$work/analysed.o"
    # shellcheck disable=SC2086
    try clang $own -Weverything $off -c "$file" -o "$work/analysed.o"
done
# The sources are C++ too, for those who drop the single header into it.
for cc in g++ clang++; do
    # shellcheck disable=SC2086
    try $cc -x c++ -std=c++11 -Wall -Wextra -Wpedantic -Werror \
        -I"$SRC/include" -I"$SRC/lib" -fsyntax-only "$SRC"/lib/*.c \
        "$SRC"/lib/real/*.c "$OUT"/float/*.c
done
for cc in gcc clang; do
    try $MAKE --no-print-directory -f "$SRC/Makefile" "O=$work/$cc" "CC=$cc" \
        'CFLAGS=-O2 -Werror' all examples build-tests build-bench
done
exit $status
