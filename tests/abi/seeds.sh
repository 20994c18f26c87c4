#!/bin/sh
# SPDX-License-Identifier: MIT
# Breaks the ABI in many ways, in a copy of the sources: abi.sh must see each,
# in all the ways that are named here.
# From `make abi-seeds`: MAKE CC SRC OUT VERSION SOVERSION PYTHON.
set -eu
work=$OUT/abi-seeds
copy=$work/source
missed=0
rm -rf "$work"
mkdir -p "$work"

# A copy to break, and what it gives unbroken.
fresh()
{
    rm -rf "$copy"
    mkdir -p "$copy/tests"
    cp -r "$SRC/Makefile" "$SRC/include" "$SRC/lib" "$SRC/LICENSE" \
        "$SRC/pkgconfig" "$copy"
    cp -r "$SRC/tests/abi" "$SRC/tests/ffi" "$copy/tests"
}

build()
{
    $MAKE --no-print-directory -C "$copy" O=build CFLAGS="-O0 -w ${1:--g}" \
        build/librollcoin.so >"$work/build.log" 2>&1 ||
        { cat "$work/build.log"; exit 1; }
}

# edit FILE SED: what the edit leaves as it was is no seed.
edit()
{
    cp "$copy/$1" "$work/before"
    sed -i "$2" "$copy/$1"
    ! cmp -s "$copy/$1" "$work/before" || { echo "no seed: $2"; exit 1; }
}

# gives WHAT WORDS: the gate must fail, and its last line hold the words.
gives()
{
    if (
        SRC=$copy OUT=$copy/build
        unset LIBRARY INCLUDE BASE
        export SRC OUT CC VERSION SOVERSION PYTHON
        sh "$copy/tests/abi/abi.sh"
    ) >"$work/log" 2>&1; then
        last="the gate passed"
    else
        last=$(tail -1 "$work/log")
    fi
    case $last in
    *"$2"*) echo "seen    $1: $2" ;;
    *)
        echo "MISSED  $1: not '$2' but '$last'"
        missed=1
        ;;
    esac
}

fresh
build
sh -c 'SRC=$1 OUT=$1/build; export SRC OUT; sh "$SRC/tests/abi/abi.sh"' - \
    "$copy" >"$work/log" 2>&1 ||
    { cat "$work/log"; echo "the baseline is old: make abi-update"; exit 1; }
echo "passes  unbroken"

(PYTHON=/nowhere/python3; gives "a missing tool" "needs /nowhere/python3")
mv "$copy/tests/abi/$SOVERSION/layout.txt" "$work"
gives "a missing baseline" "there is no"
mv "$work/layout.txt" "$copy/tests/abi/$SOVERSION"

edit include/coin.h 's/COIN_ESTEP = -3/COIN_ESTEP = -9/'
build
gives "a constant with another value" "changed: constants;"

fresh
edit include/coin.h 's/visibility("default")))/visibility("default"), cold))/'
build
gives "a macro with another value" "changed: macros;"

fresh
edit include/coin.h 's/^    double normal; /    double extra; double normal; /'
build
gives "a member inserted" "changed: layout types client;"

fresh
edit include/coin.h '/^    double wY;/{h;d};/^    double wZ;/{G;}'
build
gives "two members in each other's place" "changed: layout types client;"

fresh
edit lib/about/rollcoin.map '/coin_critical_spin;/d'
build
gives "a symbol dropped" "changed: symbols types client;"

fresh
edit include/coin.h 's/size_t count/uint32_t count/'
edit lib/step/run.c 's/size_t count/uint32_t count/'
edit lib/step/batch.c 's/size_t count/uint32_t count/'
build
gives "an argument of another type" "changed: functions types;"

fresh
edit include/coin.h 's/^COIN_API double coin_energy.*/&/;
    s/^COIN_API uint32_t coin_version(void);/&\nCOIN_API int32_t coin_new(void);/'
edit lib/about/version.c '$a int32_t coin_new(void) { return 0; }'
edit lib/about/rollcoin.map 's/^    coin_version;/    coin_new;\n&/'
build
gives "a function added" "changed: symbols functions types;"

fresh
build -g0
gives "no debug information" "has no debug information"

# Both directions, with a function that a later release adds in a node of its
# own: programs of today run with the library of tomorrow; those of tomorrow are
# refused by the library of today, at the start, unless they need nothing new.
fresh
edit include/coin.h \
    's/^COIN_API uint32_t coin_version(void);/&\nCOIN_API int32_t coin_new(void);/'
edit lib/about/version.c '$a int32_t coin_new(void) { return 0; }'
edit lib/about/rollcoin.map '$a ROLLCOIN_0.2 { coin_new; } ROLLCOIN_0;'
build
for name in version new; do
    echo "#include <coin.h>
        int main(void) { return coin_$name() == 99; }" |
        $CC -I"$copy/include" -x c - -x none \
            "$copy/build/librollcoin.so" -o "$work/$name"
done
runs() { LD_LIBRARY_PATH=$1 "$2" 2>"$work/refusal"; }
if runs "$OUT" "$work/version" && runs "$copy/build" "$work/new" &&
    ! runs "$OUT" "$work/new" &&
    grep -q "version .ROLLCOIN_0.2. not found" "$work/refusal"; then
    echo "refused  a program of tomorrow: $(sed 's/.*: //' "$work/refusal")"
else
    echo "MISSED  a program of tomorrow is not refused"
    missed=1
fi

test $missed = 0 || { echo "abi-seeds: MISSED some" >&2; exit 1; }
echo "abi-seeds: each break of the ABI is seen"
