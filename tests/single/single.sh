#!/bin/sh
# SPDX-License-Identifier: MIT
# The whole library as one header, by a user's own flags: all tests pass on it,
# in the user's file and as a file of its own, as C and as C++; it moves coins
# by the pinned bits; it keeps its names and its flags to itself.
# From `make single-check`: CC SRC OUT SINGLE RELEASE PROGS SUPPORT SEES CMOCKA
# CMOCKA_LIBS.
set -eu
work=$OUT/single/check
here=$(dirname "$SINGLE")
rm -rf "$work"
mkdir -p "$work"
failed=

fail() { echo "FAILED: $*"; failed="$failed; $*"; }

# passes NAME PROGRAM...: runs tests.
passes()
{
    name=$1
    count=0
    shift
    for program in "$@"; do
        "$program" >"$work/log" 2>&1 ||
            { tail -5 "$work/log"; fail "$name: $(basename "$program")"; }
        count=$((count + 1))
    done
    test $count -gt 0 || fail "$name: no test"
    echo "$count test programs run, $name"
}

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

# ---------------------------------------------------- tests, in the user's file
# What sources share is extern here, since tests/support calls some of it.
rooms=$(for room in "$SRC"/lib/*/; do printf '%s ' "-I'$room'"; done)
mkdir "$work/inside"
for file in "$SRC"/tests/support/*.c; do
    # shellcheck disable=SC2086
    eval $CC -std=c11 -w -O1 -I"$here" "$rooms" "$SEES" $CMOCKA -c "$file" \
        -o "$work/inside/$(basename "$file" .c).o"
done
# inside PROGRAM: a test with the code in its own file, and after it the macros
# of kind.h, which the code takes back and headers of lib/ that it holds use.
inside()
{
    file=$SRC/tests/$(basename "$1").c
    # shellcheck disable=SC2086
    eval $CC -std=c99 -w -O0 -D_POSIX_C_SOURCE=200809L -DCOIN_IMPLEMENTATION \
        -DCOIN_PRIV=extern -include "$SINGLE" -include kind.h \
        -I"$here" "$rooms" -I"$SRC/tests/support" "$SEES" $CMOCKA "$file" \
        "$work/inside/*.o" -o "$work/inside/$(basename "$1")" $CMOCKA_LIBS -lm
}
# Three tests compile what the header has compiled already, and so would define
# it twice, or not at all: lib/motion/angles.t.h for lanes, lib/step/lanes.c, and
# lib/step/advance.h with its steps counted.
twice="test_angles test_batch test_passes"
# As many at once as there are processors; one that fails leaves no program to
# run.
set --
for program in $PROGS; do
    case " $twice " in
    *" $(basename "$program") "*) continue ;;
    esac
    inside "$program" &
    set -- "$@" "$work/inside/$(basename "$program")"
    test $(($# % $(nproc))) != 0 || wait
done
wait
passes "each with the code inside, $CC -std=c99" "$@"

# -------------------------------------------------- tests, by a file of its own
# By a user's flags clang may compute what a branch then drops: it raises
# exceptions that the source does not, unless -ffp-exception-behavior=maytrap
# forbids (coin.h, FLOATING POINT).  So the tests of traps are left out there.
traps="test_traps test_traps_edges test_float_traps test_orbit_edges"
while read -r private compiler; do
    # shellcheck disable=SC2086
    echo '#include <coin.h>' | $compiler "-DCOIN_PRIV=$(echo $private |
        tr _ ' ')" -DCOIN_IMPLEMENTATION -I"$here" -c - -o "$work/coin.o"
    case $compiler in
    *maytrap*) left_out= ;;
    clang*) left_out=$traps ;;
    *) left_out= ;;
    esac
    set --
    for program in $PROGS; do
        case " $left_out " in
        *" $(basename "$program") "*) continue ;;
        esac
        # shellcheck disable=SC2086
        $CC "$program.o" $SUPPORT "$work/coin.o" $CMOCKA_LIBS -lm \
            -o "$work/$(basename "$program")" || fail "$program, $compiler"
        set -- "$@" "$work/$(basename "$program")"
    done
    passes "$compiler" "$@"
done <<END
extern gcc -x c -std=c99 -O2
extern clang -x c -std=gnu17 -O3 -march=native
extern clang -x c -std=c99 -O3 -march=native -ffp-exception-behavior=maytrap
extern_"C" g++ -x c++ -std=c++11 -O2
extern_"C" clang++ -x c++ -std=c++20 -O3 -march=native
END

# ----------------------------------------------------------------- pinned bits --
# moves FLAGS: what the pinned motions hash to, in found.txt.
moves()
{
    # shellcheck disable=SC2086
    $1 -w -DCOIN_IMPLEMENTATION -I"$here" "$SRC/tests/repro/hash.c" \
        -o "$work/hash" -lm && "$work/hash" >"$work/found.txt"
}
while read -r compiler; do
    moves "$compiler" && cmp "$SRC/tests/repro/expected.txt" "$work/found.txt" &&
        echo "same bits  $compiler" || fail "other bits: $compiler"
done <<END
gcc -O0
gcc -std=gnu11 -O3 -march=native
gcc -std=gnu11 -O3 -march=native -ffp-contract=fast
gcc -O2 -flto
g++ -x c++ -O3 -march=native
clang -std=gnu11 -O3 -march=native
clang++ -x c++ -O3 -march=native
tcc
musl-gcc -O2 -static
END

# ------------------------------------------------------- what must not pass --
for compiler in "gcc -Ofast" "g++ -x c++ -ffast-math" "clang -ffast-math" \
    "gcc -fassociative-math -fno-signed-zeros -fno-trapping-math"; do
    ! moves "$compiler" 2>/dev/null && echo "refused    $compiler" ||
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
for compiler in clang "clang++ -x c++"; do
    compiler="$compiler -O2 $can_fuse -ffp-contract=fast"
    # shellcheck disable=SC2086
    $compiler -w -I"$here" "$work/fused.c" -o "$work/fused" -lm &&
        "$work/fused" && echo "reported   $compiler" ||
        fail "not reported: $compiler"
done

# ------------------------------------------------------------ the user's own --
fused()
{
    objdump -d --no-show-raw-insn "$@" |
        grep -cE '\<v?fn?m(add|sub|la|ls|acc|sac)' || :
}
for compiler in gcc clang "g++ -x c++" "clang++ -x c++"; do
    # shellcheck disable=SC2086
    $compiler -Wall -Wextra -Wno-unused-function -Werror -O3 $can_fuse \
        -I"$here" "$SRC/tests/single/user.c" -c -o "$work/user.o"
    names=$(nm -g --defined-only "$work/user.o" | sed 's/.* //' | tr '\n' ' ')
    all=$(fused "$work/user.o")
    own=$(fused --disassemble=main "$work/user.o")
    own=$((own + $(fused --disassemble="${names%% *}" "$work/user.o")))
    echo "$compiler: exports $names, $own of $all fused are the user's"
    test "$own" = "$all" || fail "$compiler fuses in the library"
    test -z "$can_fuse" || test "$own" -gt 0 ||
        fail "$compiler: the user's flags are lost"
    case $names in
    *coin*) fail "$compiler: exports $names" ;;
    esac
    # shellcheck disable=SC2086
    ${compiler%% *} "$work/user.o" -o "$work/user" -lm && "$work/user" ||
        fail "$compiler: the user's program rolls no coin"
done

test -z "$failed" || { echo "single-check: FAILED${failed#;}" >&2; exit 1; }
echo "single-check: passed"
