#!/bin/sh
# SPDX-License-Identifier: MIT
# Breaks the ABI in many ways, in a copy of the sources: abi.sh must see each,
# in all the ways that are named here.  What docs/installing.md allows must pass.
# From `make abi-seeds`: MAKE CC SRC OUT VERSION SOVERSION PYTHON.
set -eu
work=$OUT/abi-seeds
unbroken=$work/unbroken
copy=$unbroken
rm -rf "$work"
mkdir -p "$work"
. "$SRC/tests/at_once.sh"

# seed NUMBER NAME: a function below, with a copy to break.  It was built
# unbroken: make then compiles what an edit touches.
seed()
{
    work=$work/$2
    copy=$work/source
    mkdir "$work"
    cp -a "$unbroken" "$copy"
    missed=0
    "$2"
    test $missed = 0
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

# The gate on the copy: gate [update | release].
gate()
{
    (
        SRC=$copy OUT=$copy/build
        unset LIBRARY INCLUDE BASE
        export SRC OUT CC VERSION SOVERSION PYTHON
        sh "$copy/tests/abi/abi.sh" "$@"
    ) >"$work/log" 2>&1
}

# gives WHAT WORDS [update]: the gate must fail, and its last line hold the
# words.
gives()
{
    # shellcheck disable=SC2086
    if gate ${3:-}; then
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

# passes WHAT [update | release]: what is allowed must not be refused.
passes()
{
    # shellcheck disable=SC2086
    if gate ${2:-}; then
        echo "passes  $1"
    else
        cat "$work/log"
        echo "REFUSED $1"
        missed=1
    fi
}

mkdir -p "$copy/tests"
cp -r "$SRC/Makefile" "$SRC/include" "$SRC/lib" "$SRC/LICENSE" \
    "$SRC/pkgconfig" "$copy"
cp -r "$SRC/tests/abi" "$SRC/tests/ffi" "$copy/tests"
rm -rf "$copy/tests/abi/$SOVERSION/released"
build
gate || { cat "$work/log"; echo "the baseline is old: make abi-update"; exit 1; }
echo "passes  unbroken"

# ------------------------------------------------------------------- the breaks
missing_tool()
{
    PYTHON=/nowhere/python3
    gives "a missing tool" "needs /nowhere/python3"
}

missing_baseline()
{
    rm "$copy/tests/abi/$SOVERSION/layout.txt"
    gives "a missing baseline" "there is no"
}

constant()
{
    edit include/coin.h 's/COIN_ESTEP = -3/COIN_ESTEP = -99/'
    build
    gives "a constant with another value" "changed: constants;"
}

macro()
{
    edit include/coin.h 's/visibility("default")))/visibility("default"), cold))/'
    build
    gives "a macro with another value" "changed: macros;"
}

insert_member()
{
    edit include/coin.h 's/^    double normal; /    double extra; double normal; /'
    build
}

member()
{
    insert_member
    gives "a member inserted" "changed: layout types client;"
}

order()
{
    edit include/coin.h '/^    double wY;/{h;d};/^    double wZ;/{G;}'
    build
    gives "two members in each other's place" "changed: layout types client;"
}

# As long as a double, but for processors of 32 bits.
width()
{
    edit include/coin.h 's/^    double conditioning;/    size_t conditioning;/'
    build
    gives "a member of another size on 32 bits" "changed: i686"
}

# No compiled program sees a name; a binding does.
member_name()
{
    for file in include/coin.h $(cd "$copy" && grep -lw radius_min lib/*/*.c); do
        edit "$file" 's/\<radius_min\>/radius_inner/g'
    done
    build
    gives "a member renamed" "changed: layout client;"
}

argument_order()
{
    edit include/coin.h \
        '/coin_steady_turn(/,/;/s/double theta, double radius/double radius, double theta/'
    gives "two arguments in each other's place" "changed: functions;"
}

symbol()
{
    edit lib/about/rollcoin.map '/coin_critical_spin;/d'
    build
    gives "a symbol dropped" "changed: symbols types client;"
}

argument()
{
    for file in include/coin.h lib/step/coin_run.c lib/step/batch.c; do
        edit $file 's/size_t count/uint32_t count/'
    done
    build
    gives "an argument of another type" "changed: functions types;"
}

# add_function MAP: with an edit of the list of symbols.
add_function()
{
    edit include/coin.h \
        's/^COIN_API uint32_t coin_version(void);/&\nCOIN_API int32_t coin_new(void);/'
    edit lib/about/version.c '$a int32_t coin_new(void) { return 0; }'
    edit lib/about/rollcoin.map "$1"
    build
}
of_today='s/^    coin_version;/    coin_new;\n&/'

function()
{
    add_function "$of_today"
    gives "a function added" "changed: symbols functions types;"
}

no_debug()
{
    build -g0
    gives "no debug information" "has no debug information"
}

# Members called reserved are divided.
use_reserved()
{
    edit include/coin.h '0,/double reserved\[2\];/s//double tilt; double reserved[1];/'
    edit include/coin.h 's/double reserved\[26\];/double spin; double reserved[25];/'
    edit include/coinf.h 's/float reserved\[2\];/float tilt; float reserved[1];/'
    edit lib/motion/params.h 's/are_zero(p->reserved, 2)/are_zero(p->reserved, 1)/'
    build
}

reserved()
{
    use_reserved
    gives "reserved members used" "changed: layout types;"
}

# ------------------------------------------------------ once a release has been
major=${VERSION%%.*} patch=${VERSION##*.}
minor=${VERSION#*.} minor=${minor%.*}
newest=$(sed -n 's/^\(ROLLCOIN_[0-9.]*\) {.*/\1/p' "$SRC/lib/about/rollcoin.map" |
    tail -1)
next=$newest.next

# The copy becomes that of the version after the release of this one.
after_release()
{
    passes "a release" release
    edit include/coin.h "s/\(COIN_VERSION_PATCH\) .*/\1 $((patch + 1))/"
}

member_after_release()
{
    after_release
    insert_member
    gives "a member inserted after a release" "a break of the ABI of a release" update
}

reserved_after_release()
{
    after_release
    use_reserved
    passes "reserved members used after a release" update
    passes "the same, accepted"
}

argument_after_release()
{
    after_release
    edit include/coin.h 's/coin_energy(const coin_state \*s,/coin_energy(const coin_state *now,/'
    gives "an argument renamed after a release" "a break of the ABI of a release" update
}

symbol_after_release()
{
    after_release
    add_function "$of_today"
    gives "a symbol in a node of a release" "a break of the ABI of a release" update
}

# Both directions, with a new function: programs of today run with the library
# of tomorrow; those of tomorrow are refused by the library of today, at the
# start, unless they need nothing new.
node_after_release()
{
    after_release
    add_function "\$a $next { coin_new; } $newest;"
    passes "a symbol in a node of its own" update
    for name in version new; do
        echo "#include <coin.h>
            int main(void) { return coin_$name() == 99; }" |
            $CC -I"$copy/include" -x c - -x none \
                "$copy/build/librollcoin.so" -o "$work/$name"
    done
    if runs "$OUT" "$work/version" && runs "$copy/build" "$work/new" &&
        ! runs "$OUT" "$work/new" &&
        grep -q "version .$next. not found" "$work/refusal"; then
        echo "refused  a program of tomorrow: $(sed 's/.*: //' "$work/refusal")"
    else
        echo "MISSED  a program of tomorrow is not refused"
        missed=1
    fi
}
runs() { LD_LIBRARY_PATH=$1 "$2" 2>"$work/refusal"; }

# Before 1.0 a member that is inserted takes a version whose soname is another.
soname()
{
    test "$major" = 0 || return 0
    next_minor=$major.$((minor + 1))
    edit include/coin.h "s/\(COIN_VERSION_MINOR\) .*/\1 $((minor + 1))/"
    insert_member
    soname=$(readelf -d "$copy/build/librollcoin.so" |
        sed -n 's/.*soname: \[\(.*\)\]/\1/p')
    if test "$soname" = "librollcoin.so.$next_minor"; then
        echo "passes  a member inserted at $next_minor: it is $soname"
    else
        echo "MISSED  a member inserted at $next_minor: it is $soname"
        missed=1
    fi
    VERSION=$next_minor.0
    gives "a member inserted at $next_minor under the same soname" \
        "is not librollcoin.so.$SOVERSION" update
}

at_once seed <<END || { echo "abi-seeds: MISSED some" >&2; exit 1; }
missing_tool
missing_baseline
constant
macro
member
order
width
member_name
argument_order
symbol
argument
function
no_debug
reserved
member_after_release
reserved_after_release
argument_after_release
symbol_after_release
node_after_release
soname
END
echo "abi-seeds: each break of the ABI is seen, and what is allowed passes"
