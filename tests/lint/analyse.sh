#!/bin/sh
# SPDX-License-Identifier: MIT
# The sources are clean under cppcheck, gcc's analyzer and clang's warnings, and
# the examples compile without a warning by both compilers.
# From `make lint`: SRC OUT WARN.
set -eu
work=$OUT/lint
mkdir -p "$work"
. "$SRC/tests/at_once.sh"

status=0

try() { "$@" || status=1; }

# badBitmaskCheck: COIN_VERSION_MAJOR << 16 may well be 0.
try cppcheck -j "$(nproc)" --quiet --std=c99 --error-exitcode=1 --inline-suppr \
    --enable=warning,style,performance,portability \
    --suppress=missingIncludeSystem --suppress=badBitmaskCheck \
    -DCOIN_API= -I"$SRC/include" "$SRC"/lib/*/*.c

# Off for clang: float-equal, as NaN and exact zeros are compared on purpose;
# double-promotion, as NAN and INFINITY are floats, and gcc keeps watch;
# documentation, which does not know "@param x,z"; declaration-after-statement
# and padded, which are no faults; vector-conversion, as comparisons give
# vectors of long long, where int64_t may be long; used-but-marked-unused, as a
# source uses some of a header's functions; disabled-macro-expansion, as a name
# of vector_names.h is to mean itself for one number.
off="-Wno-float-equal -Wno-double-promotion -Wno-documentation
    -Wno-declaration-after-statement -Wno-padded -Wno-vector-conversion
    -Wno-used-but-marked-unused -Wno-disabled-macro-expansion"
# Off for gcc: what is used uninitialised, since its analyzer does not follow a
# loop over a vector's members; make msan looks for that.
own="-std=c99 -O2 -ffp-contract=off -Werror -I$SRC/include"
# analysed NUMBER FILE
analysed()
{
    object=$work/analysed.$1.o
    # shellcheck disable=SC2086
    gcc $own $WARN -Wdouble-promotion -fanalyzer \
        -Wno-analyzer-use-of-uninitialized-value -c "$2" -o "$object" &&
        clang $own -Weverything $off -fsyntax-only "$2"
}
ls "$SRC"/lib/*/*.c >"$work/sources"
try at_once analysed <"$work/sources"

# The sources are C++ too, for those who drop the single header into it.
as_cpp()
{
    $2 -x c++ -std=c++11 -Wall -Wextra -Wpedantic -Werror \
        -I"$SRC/include" -fsyntax-only "$SRC"/lib/*/*.c
}
try at_once as_cpp <<END
g++
clang++
END

# Examples; the tests' own warnings are errors in `make sanitize` and `make msan`.
# compiled NUMBER FILE
compiled()
{
    for cc in gcc clang; do
        $cc -std=c99 -O2 -fopenmp $WARN -Werror -I"$SRC/include" -c "$2" \
            -o "$work/compiled.$1.o" || return
    done
}
ls "$SRC"/docs/examples/*.c >"$work/sources"
try at_once compiled <"$work/sources"
exit $status
