#!/bin/sh
# SPDX-License-Identifier: MIT
# The bindings of docs/examples: their declarations are those of coin.h, every
# size, offset, constant and prototype; errors become what the language has
# for them; and each rolls the quarter to the very digits of quarter.c.
#     ffi.sh [update | declarations]
# From `make bindings`: CC CXX SRC OUT PYTHON RUSTC CARGO BINDGEN.
set -eu
here=$SRC/tests/ffi
examples=$SRC/docs/examples
package=$examples/python/src/rollcoin
raw=$examples/rust/src/ffi.rs
work=$OUT/ffi
failed=
export CC

die() { echo "bindings: $*" >&2; exit 1; }
differs() { echo "bindings: $1"; failed="$failed; $1"; }

need()
{
    for tool; do
        command -v "${tool%% *}" >/dev/null || die "needs $tool"
    done
}

need "$PYTHON" "$BINDGEN" rustfmt
rm -rf "$work"
mkdir -p "$work"

# Python writes no caches into the sources.
export PYTHONDONTWRITEBYTECODE=1

# ----------------------------------------------------------------- declarations
rust_declarations()
{
    "$BINDGEN" "$SRC/include/coinf.h" "$@" \
        --allowlist-function 'coinf?_.*' --allowlist-type 'coinf?_.*' \
        --allowlist-var 'COIN_.*' --blocklist-type '__u?int.*' \
        --no-doc-comments --size_t-is-usize --with-derive-default \
        --with-derive-partialeq \
        --raw-line '// SPDX-License-Identifier: MIT' \
        --raw-line '// What coin.h and coinf.h declare: by `make bindings-update`.' \
        -- "-I$SRC/include" -std=c99
}
"$PYTHON" "$here/python.py" declarations "$SRC/include" \
    >"$work/_declarations.py" || die "pycparser cannot read coin.h"
"$PYTHON" "$here/python.py" tables "$SRC/include" >"$work/tables.h"
rust_declarations --no-layout-tests >"$work/ffi.rs" ||
    die "bindgen cannot read coin.h"

"$PYTHON" "$here/declare.py" csharp "$SRC/include" >"$work/rollcoin.cs"
"$PYTHON" "$here/declare.py" typescript "$SRC/include" >"$work/rollcoin.d.ts"
"$PYTHON" "$here/declare.py" javascript "$SRC/include" \
    <"$examples/js/rollcoin.mjs" >"$work/rollcoin.mjs"

if test "${1:-}" = update; then
    cp "$work/_declarations.py" "$work/tables.h" "$package"
    cp "$work/rollcoin.cs" "$examples/csharp"
    cp "$work/rollcoin.d.ts" "$work/rollcoin.mjs" "$examples/js"
    cp "$work/ffi.rs" "$raw"
    echo "bindings: declarations renewed"
    exit
fi
need "$CC" "$CXX" "$RUSTC" "$CARGO" cargo-clippy pip3 mypy
{ diff "$package/_declarations.py" "$work/_declarations.py" &&
    diff "$package/tables.h" "$work/tables.h"; } ||
    differs "Python's declarations"
diff "$raw" "$work/ffi.rs" || differs "Rust's declarations"
diff "$examples/csharp/rollcoin.cs" "$work/rollcoin.cs" || differs "rollcoin.cs"
diff "$examples/js/rollcoin.d.ts" "$work/rollcoin.d.ts" ||
    differs "rollcoin.d.ts"
diff "$examples/js/rollcoin.mjs" "$work/rollcoin.mjs" || differs "rollcoin.mjs"

# The same by another route: what the C compiler, ctypes and rustc make of it.
"$PYTHON" "$here/header.py" "$SRC/include" layout >"$work/layout.c.txt"
"$PYTHON" "$here/python.py" layout "$package" >"$work/layout.py.txt" &&
    diff "$work/layout.c.txt" "$work/layout.py.txt" ||
    differs "Python's layout"
rust_declarations >"$work/tested.rs"
grep -q 'Offset of field' "$work/tested.rs" || die "bindgen tests nothing"
"$RUSTC" --edition 2021 --test -A warnings "$work/tested.rs" \
    -o "$work/tested" -L "native=$OUT" -l static=rollcoin -l m &&
    "$work/tested" -q >"$work/log" || { cat "$work/log"
    differs "Rust's layout"; }
# calls NAME FILES...: every function of coin.h is called there, but those that
# a compiled header makes needless.
calls()
{
    name=$1
    shift
    "$PYTHON" "$here/header.py" "$SRC/include" functions |
        grep -o '\bcoin_[a-z0-9_]*(' |
        grep -v -e '_sizeof' -e '_version' -e '_string' |
        while read -r call; do
            cat "$@" | grep -qF "$call" || echo "$name lacks $call)"
        done | grep . && differs "$name's calls" || true
}
calls C++ "$examples/cpp/rollcoin.hpp"
calls Rust "$examples"/rust/src/[!ft]*.rs

echo "bindings: $(wc -l <"$work/layout.c.txt") sizes and offsets," \
    "$(grep -c 'pub fn' "$raw") functions in Python and Rust as in coin.h"
test "${1:-}" != declarations ||
    { test -z "$failed" || die "differ:${failed#;}: make bindings-update"; exit; }

# ------------------------------------------------------------------------- tests
# As a new user has it: in a virtual environment, by pip, without a network,
# with the library in the package; and then linked to an installed one.
"$PYTHON" -m venv --system-site-packages --without-pip "$work/venv"
python=$work/venv/bin/python
pip="$python -m pip -q --disable-pip-version-check install --no-index --no-deps"
(
    cd /
    $pip "$examples/python" && "$python" "$here/test_python.py" -q &&
        "$python" -m mypy --cache-dir="$work/mypy" \
            --config-file "$examples/python/pyproject.toml" "$package"
) || differs "the tests of Python"
sh "$here/packages.sh" "$work" "$python" || differs "Python's packages"
for std in c++17 c++20; do
    for cxx in "$CXX" clang++; do
        # shellcheck disable=SC2086
        $cxx -std=$std -Wall -Wextra -Wpedantic -Wconversion -Werror \
            -I"$SRC/include" -I"$examples/cpp" "$here/test_cpp.cpp" \
            "$OUT/librollcoin.a" -lm -o "$work/test_cpp" && "$work/test_cpp" ||
            differs "the tests of C++, $cxx -std=$std"
    done
done
cp -r "$examples/rust" "$work/rust"
(
    cd "$work/rust"
    export ROLLCOIN_LIB="$OUT" RUSTC CARGO_TARGET_DIR="$work/cargo"
    export RUSTFLAGS='-D warnings'
    "$CARGO" clippy --offline -q --all-targets -- -D warnings &&
        rustfmt --check --edition 2021 src/lib.rs build.rs examples/*.rs &&
        "$CARGO" test --offline -q
) >"$work/log" 2>&1 || { cat "$work/log"; differs "the tests of Rust"; }
grep '^test result' "$work/log" | head -1
# Without ROLLCOIN_LIB: the installed library, and the single header.
(
    cd "$work/rust"
    unset ROLLCOIN_LIB
    export RUSTC CARGO_TARGET_DIR="$work/cargo" ROLLCOIN_CLONE="$SRC"
    PKG_CONFIG_PATH=$work/stage/lib/pkgconfig "$CARGO" build --offline -q &&
        grep -rq "native=$work/stage/lib" "$work"/cargo/debug/build/*/output &&
        PKG_CONFIG_LIBDIR=/nowhere "$CARGO" test --offline -q
) >"$work/log" 2>&1 || { cat "$work/log"; differs "the crate's library"; }

# ------------------------------------------------------------ the same numbers
"$OUT/quarter" >"$work/quarter.txt"
test "$(wc -l <"$work/quarter.txt")" = 11 || differs "quarter.c"

# same NAME COMMAND...: what it prints is what quarter.c prints.
same()
{
    name=$1
    shift
    "$@" >"$work/found.txt" && cmp "$work/quarter.txt" "$work/found.txt" ||
        { differs "$name prints something else"; return; }
    echo "same numbers  $name"
}
$CXX -std=c++17 -I"$SRC/include" "$examples/cpp/quarter.cpp" \
    "$OUT/librollcoin.a" -lm -o "$work/quarter-cpp"
same C++ "$work/quarter-cpp"
same Python "$python" "$examples/python/quarter.py"
same "Rust, by cargo" env ROLLCOIN_LIB="$OUT" RUSTC="$RUSTC" \
    CARGO_TARGET_DIR="$work/cargo" "$CARGO" run --offline -q \
    --manifest-path "$work/rust/Cargo.toml" --example quarter
(
    cd "$work"
    "$RUSTC" --edition 2021 -O --crate-type rlib --crate-name rollcoin \
        "$examples/rust/src/lib.rs" -L "native=$OUT" -l static=rollcoin -l m
    "$RUSTC" --edition 2021 -O "$examples/rust/examples/quarter.rs" \
        --extern rollcoin=librollcoin.rlib -o quarter-rs
)
same "Rust, by rustc" "$work/quarter-rs"
"$python" "$examples/python/toss.py" 100 >"$work/quarter.txt"
grep -q ' of 100 show heads' "$work/quarter.txt" || differs "toss.py"
same "C, tosses by threads as Python's" "$OUT/many_tosses" 100
for bad in 0 1e5; do
    ! "$OUT/many_tosses" $bad 2>"$work/log" && grep -q '^usage: ' "$work/log" ||
        differs "many_tosses $bad"
done
same "Rust, tosses as Python's" env ROLLCOIN_LIB="$OUT" RUSTC="$RUSTC" \
    CARGO_TARGET_DIR="$work/cargo" "$CARGO" run --offline -q \
    --manifest-path "$work/rust/Cargo.toml" --example toss 100

test -z "$failed" || die "differ:${failed#;}"
echo "bindings: as coin.h says"
