#!/bin/sh
# SPDX-License-Identifier: MIT
# Lets coin.h and the bindings drift apart, in a copy: `ffi.sh declarations`
# must see each drift, in all the ways that are named here.
#     seeds.sh [HALF]     from `make bindings-seeds`: CC CXX SRC OUT PYTHON RUSTC
#                         CARGO BINDGEN; HALF, 0 or 1, tries every second drift
set -eu
if test $# = 0; then
    . "$SRC/tests/at_once.sh"
    half() { sh "$SRC/tests/ffi/seeds.sh" "$2"; }
    at_once half <<END || { echo "bindings-seeds: MISSED some" >&2; exit 1; }
0
1
END
    echo "bindings-seeds: each drift is seen"
    exit
fi
half=$1
work=$OUT/ffi-seeds/$half
copy=$work/source
missed=0
number=0
rm -rf "$work"
mkdir -p "$work"
export CC CXX PYTHON RUSTC CARGO BINDGEN

fresh()
{
    rm -rf "$copy"
    mkdir -p "$copy/docs" "$copy/tests" "$copy/build"
    cp -r "$SRC/include" "$copy"
    cp -r "$SRC/docs/examples" "$copy/docs"
    cp -r "$SRC/tests/ffi" "$copy/tests"
    cp "$OUT"/librollcoin.* "$copy/build"
}

# gives WHAT: the gate must fail, and its last line be "differ: $2".
gives()
{
    if SRC=$copy OUT=$copy/build sh "$copy/tests/ffi/ffi.sh" declarations \
        >"$work/log" 2>&1; then
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

# drift WHAT SEEN FILE SED: what the edit leaves as it was is no seed.
drift()
{
    number=$((number + 1))
    test $((number % 2)) = "$half" || return 0
    fresh
    sed -i "$4" "$copy/$3"
    ! cmp -s "$copy/$3" "$SRC/$3" || { echo "no seed: $4"; exit 1; }
    gives "$1" "$2"
}

fresh
SRC=$copy OUT=$copy/build sh "$copy/tests/ffi/ffi.sh" declarations \
    >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
echo "passes  undrifted"

both="Python's declarations; Rust's declarations"
three="$both; rollcoin.cs"
all="$three; rollcoin.d.ts"
five="$all; rollcoin.mjs"
update=": make bindings-update"
drift "a member inserted" "$five; Python's layout$update" include/coin.h \
    's/^    double normal; /    double extra; double normal; /'
drift "two members in each other's place" "$five; Python's layout$update" \
    include/coin.h '/^    double wY;/{h;d};/^    double wZ;/{G;}'
drift "an argument of another type" "$three$update" include/coin.h \
    's/size_t count/int32_t count/'
drift "an argument gone" "$all$update" include/coin.h \
    's/const coin_params \*p, double dt);/const coin_params *p);/'
drift "a constant with another value" "$three; rollcoin.mjs$update" \
    include/coin.h 's/COIN_ESTEP = -3/COIN_ESTEP = -99/'
drift "a constant added" "$five$update" include/coin.h \
    's;COIN_DECIDED = 256 .*;COIN_DECIDED = 256, /**< a */ COIN_NEW = 512 /**< b */;'
drift "an array of another type" "$all$update" include/coin.h \
    's/int32_t \*status/double *status/'
drift "a function added" "$all; C++'s calls; Rust's calls$update" include/coin.h \
    's/^COIN_API uint32_t coin_version(void);/&\nCOIN_API double coin_new(void);/'
drift "a kind of type that no binding knows" "pycparser cannot read coin.h" \
    include/coin.h 's/^    double ratio;/    union { int a; } u; double ratio;/'

drift "a function of floats added" "$both$update" include/coinf.h \
    's/^COIN_API int32_t coinf_selftest(void);/&\nCOIN_API float coinf_new(void);/'

python=docs/examples/python/src/rollcoin/_declarations.py
drift "a member swapped in Python" "Python's declarations; Python's layout" \
    $python '/^        ("wY"/{h;d};/^        ("wZ"/{G;}'
drift "a prototype changed in Python" "differ: Python's declarations$update" \
    $python 's/"coin_step": (c_int32,/"coin_step": (c_double,/'
drift "a function over tables changed in Python" \
    "differ: Python's declarations$update" \
    docs/examples/python/src/rollcoin/tables.h 's/q + 4 \* i/q + 3 * i/'
drift "a function no longer called in C++" "differ: C++'s calls$update" \
    docs/examples/cpp/rollcoin.hpp 's/coin_settle(/coin_advance(/'
drift "a function no longer called in Rust" "differ: Rust's calls$update" \
    docs/examples/rust/src/losses.rs 's/coin_settle(/coin_advance(/'
drift "a member's type changed in Rust" "differ: Rust's declarations$update" \
    docs/examples/rust/src/ffi.rs '0,/pub wX: f64/s//pub wX: f32/'
drift "a member moved in C#" "differ: rollcoin.cs$update" \
    docs/examples/csharp/rollcoin.cs '/public double wY;/{h;d};/public double wZ;/{G;}'
drift "a function gone from rollcoin.d.ts" "differ: rollcoin.d.ts$update" \
    docs/examples/js/rollcoin.d.ts '/coin_settle(/d'
drift "a constant gone from rollcoin.mjs" "differ: rollcoin.mjs$update" \
    docs/examples/js/rollcoin.mjs 's/COIN_TOUCHES: 64, //'

fresh
BINDGEN=/nowhere/bindgen
gives "a missing tool" "needs /nowhere/bindgen"
test $missed = 0
