#!/bin/sh
# SPDX-License-Identifier: MIT
# The whole library as one header, by a user's own flags: all tests pass on it,
# compiled as C++; it moves coins by the pinned bits, inside the user's file; it
# keeps its names, its macros and its flags to itself.
# From `make single-check`: CC SRC OUT SINGLE RELEASE TESTS CMOCKA_LIBS.
set -eu
work=$OUT/single/check
here=$(dirname "$SINGLE")
rm -rf "$work"
mkdir -p "$work"
. "$SRC/tests/at_once.sh"

fail() { echo "FAILED: $*" | tee -a "$work/failed"; }

# ------------------------------------------------------------------- dialects --
# Clean under a user's warnings, with the code, which is C99 or C++11, and
# without.
{
    for std in c99 c11 c17 c2x; do
        echo "gcc -x c -std=$std"
        echo "clang -x c -std=$std"
    done
    for std in c++98 c++11 c++14 c++17 c++20; do
        echo "g++ -x c++ -std=$std -Wno-long-long"
        echo "clang++ -x c++ -std=$std -Wno-c++11-long-long"
    done
} >"$work/dialects"
while read -r compiler; do
    for code in "" -DCOIN_IMPLEMENTATION; do
        case $compiler$code in
        *c++98*IMPLEMENTATION) continue ;;
        esac
        # shellcheck disable=SC2086
        echo '#include <coin.h>' | $compiler -Wall -Wextra -pedantic -Werror \
            $code -I"$here" -fsyntax-only - || fail "$compiler $code"
    done
done <"$work/dialects"
echo "clean in $(wc -l <"$work/dialects") dialects"

# ---------------------------------------------------------- as it is released --
# The tarball's README: its program, all of it static and most of it unused,
# compiles by its command without a warning, as C and as C++, and prints what it
# says.
tar -xJf "$RELEASE" -C "$work"
released=$work/$(basename "$RELEASE" .tar.xz)
fenced() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/{/^\`/d;p}" "$released/README.md"; }
fenced c >"$released/roll.c"
fenced text >"$work/expected"
test -s "$work/expected"
(cd "$released" && sh -ec "$(fenced sh)") | diff "$work/expected" - ||
    fail "the README of the release"
for compiler in "gcc -O2 -std=c99" "clang -O2" "g++ -x c++" "clang++ -x c++ -O2"; do
    # shellcheck disable=SC2086
    $compiler -Wall -Wextra -pedantic -Werror "$released/roll.c" \
        -o "$work/roll" -lm && "$work/roll" | diff "$work/expected" - ||
        fail "the release by $compiler"
done
echo "the release of the header compiles without a warning"

# ------------------------------------------------------------------ its macros --
# Beyond those of the C library's headers each has a name of the library's own.
macros()
{
    $CC -dM -E "$@" - | sed 's/^#define \([A-Za-z_0-9]*\).*/\1/' |
        LC_ALL=C sort
}
grep '^ *#include <' "$SINGLE" | macros >"$work/theirs"
echo '#include <coin.h>' | macros -I"$here" -DCOIN_IMPLEMENTATION |
    LC_ALL=C comm -13 "$work/theirs" - >"$work/macros"
grep -q COIN_IMPLEMENTED "$work/macros" &&
    ! grep -vE '^(COINF?_|ROLLCOIN_|coinf?_priv_)' "$work/macros" ||
    fail "its macros"
echo "leaves $(wc -l <"$work/macros") macros, by names of its own"

# -------------------------------------------------- tests, by a file of its own
# As C++ all of them; by clang those that look at exceptions, which it raises
# where the source does not, unless -ffp-exception-behavior=maytrap forbids
# (docs/embedding.md).  The bits of other compilers are looked at below.
traps=$(cd "$SRC/tests" && grep -l fetestexcept test_*.c | sed 's/\.c$//' |
    tr '\n' ' ')

# apart NUMBER COMPILER: the code by a compiler, and the tests with it, in a
# folder of that number.
apart()
{
    mkdir "$work/$1"
    echo '#include <coin.h>' | eval "$2" -DCOIN_IMPLEMENTATION -I"$here" -c - \
        -o "$work/$1/coin.o" || fail "$2"
    # shellcheck disable=SC2086
    $CC $TESTS "$work/$1/coin.o" $CMOCKA_LIBS -lm -o "$work/$1/run" ||
        fail "the tests do not link, $2"
}
# passes FOLDER COMPILER NUMBER TEST: a test with that code.
passes()
{
    "$work/$1/run" "$4" >"$work/$1/$4.log" 2>&1 ||
        { tail -5 "$work/$1/$4.log"; fail "$4, $2"; }
}
cat >"$work/apart" <<'END'
clang -x c -std=c99 -O3 -march=native -ffp-exception-behavior=maytrap -DCOIN_PRIV=extern
g++ -x c++ -std=c++11 -O2 '-DCOIN_PRIV=extern "C"'
END
at_once apart <"$work/apart"
folder=0
while read -r compiler; do
    folder=$((folder + 1))
    case $compiler in
    clang*) printf '%s\n' $traps ;;
    *) printf '%s\n' $TESTS | sed -n 's,.*/\(test_.*\)\.o,\1,p' ;;
    esac >"$work/names"
    at_once passes $folder "$compiler" <"$work/names"
    echo "$(wc -l <"$work/names") tests run, $compiler"
done <"$work/apart"

# ----------------------------------------------------------------- pinned bits --
# moves NAME FLAGS: what the pinned motions hash to, in NAME.txt.
moves()
{
    # shellcheck disable=SC2086
    $2 -w -DCOIN_IMPLEMENTATION -I"$here" "$SRC/tests/repro/hash.c" \
        -o "$work/$1.hash" -lm && "$work/$1.hash" >"$work/$1.txt"
}
# same NUMBER FLAGS
same()
{
    moves "$1" "$2" && cmp "$SRC/tests/repro/expected.txt" "$work/$1.txt" &&
        echo "same bits  $2" || fail "other bits: $2"
}
at_once same <<END
gcc -std=gnu11 -O3 -march=native -ffp-contract=fast
g++ -x c++ -O3 -march=native
clang -std=gnu11 -O3 -march=native
clang++ -x c++ -O3 -march=native
tcc
END

# ------------------------------------------------------- what must not pass --
for compiler in "gcc -Ofast" "g++ -x c++ -ffast-math" "clang -ffast-math" \
    "gcc -fassociative-math -fno-signed-zeros -fno-trapping-math" \
    "gcc -ffinite-math-only" "clang -ffinite-math-only"; do
    ! moves refused "$compiler" 2>/dev/null && echo "refused    $compiler" ||
        fail "not refused: $compiler"
done
case $(uname -m) in
x86_64) can_fuse="-mavx2 -mfma" ;;
*) can_fuse= ;;
esac
cat >"$work/fused.c" <<'END'
#define COIN_IMPLEMENTATION
#include <coin.h>
int main(void)
{
    return coin_selftest() != COIN_EBUILD || coinf_selftest() != COIN_EBUILD;
}
END
# reported NUMBER COMPILER: its code says that it has other bits, or knows no NaN.
reported()
{
    # shellcheck disable=SC2086
    $2 -O2 $can_fuse -w -I"$here" "$work/fused.c" \
        -o "$work/fused.$1" -lm && "$work/fused.$1" && echo "reported   $2" ||
        fail "not reported: $2"
}
at_once reported <<END
clang -ffp-contract=fast
clang++ -x c++ -ffp-contract=fast
clang -fno-honor-nans
END

# ------------------------------------------------------------ the user's own --
fused()
{
    objdump -d --no-show-raw-insn "$@" |
        grep -cE '\<v?fn?m(add|sub|la|ls|acc|sac)' || :
}
# whole NUMBER COMPILER: the user's own flags hold for the user's code alone.
whole()
{
    object=$work/user.$1.o
    # shellcheck disable=SC2086
    $2 -Wall -Wextra -Wno-unused-function -Werror -O3 $can_fuse \
        -I"$here" "$SRC/tests/single/user.c" -c -o "$object" ||
        fail "$2: the user's file"
    names=$(nm -g --defined-only "$object" | sed 's/.* //' | tr '\n' ' ')
    all=$(fused "$object")
    own=$(fused --disassemble=main "$object")
    own=$((own + $(fused --disassemble="${names%% *}" "$object")))
    echo "$2: exports $names, $own of $all fused are the user's"
    test "$own" = "$all" || fail "$2 fuses in the library"
    test -z "$can_fuse" || test "$own" -gt 0 ||
        fail "$2: the user's flags are lost"
    case $names in
    *coin*) fail "$2: exports $names" ;;
    esac
    ${2%% *} "$object" -o "$work/user.$1" -lm && "$work/user.$1" ||
        fail "$2: the user's program rolls no coin"
}
at_once whole <<END
gcc
g++ -x c++
clang
clang++ -x c++
END

test ! -e "$work/failed" || { echo "single-check: FAILED" >&2; exit 1; }
echo "single-check: passed"
