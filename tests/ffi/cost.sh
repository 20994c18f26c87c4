#!/bin/sh
# SPDX-License-Identifier: MIT
# What a call of one step of RK4 costs from each language, in instructions,
# which are the same however busy the machine is: those of 2000 calls less
# those of 1000.
# From `make bindings-cost`: CC CXX SRC OUT PYTHON RUSTC.
set -eu
here=$SRC/tests/ffi/cost
work=$OUT/ffi-cost
examples=$SRC/docs/examples
rm -rf "$work"
mkdir -p "$work"
export PYTHONPATH="$work/site" PYTHONDONTWRITEBYTECODE=1 PYTHONHASHSEED=0

"$PYTHON" -m pip -q --disable-pip-version-check install \
    --root-user-action=ignore --no-index --no-deps --target "$work/site" \
    "$examples/python"

$CC -O2 -I"$SRC/include" "$here/calls.c" "$OUT/librollcoin.a" -lm -o "$work/c"
$CXX -O2 -std=c++17 -I"$SRC/include" -I"$examples/cpp" "$here/calls.cpp" \
    "$OUT/librollcoin.a" -lm -o "$work/cpp"
(
    cd "$work"
    "$RUSTC" --edition 2021 -O --crate-type rlib --crate-name rollcoin \
        "$examples/rust/src/lib.rs" -L "native=$OUT" -l static=rollcoin -l m
    "$RUSTC" --edition 2021 -O "$here/calls.rs" -o rs \
        --extern rollcoin=librollcoin.rlib
)

instructions()
{
    valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" "$@" \
        >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
    sed -n 's/.*Collected : //p' "$work/log"
}

# costs WHAT COMMAND...
costs()
{
    what=$1
    shift
    one=$(instructions "$@" 1000)
    two=$(instructions "$@" 2000)
    cost=$(((two - one) / 1000))
    test -n "${c:-}" || c=$cost
    echo "$what $cost $c" | awk -F'\t' '{split($2, n, " ")
        printf "%-34s %7d instructions, %5.2f times C\n", $1, n[1], n[1]/n[2]}'
}

tab=$(printf '\t')
costs "C, coin_run()$tab" "$work/c"
costs "C++, rollcoin::run()$tab" "$work/cpp"
costs "Rust, State::run()$tab" "$work/rs"
costs "Python, lib.coin_run()$tab" "$PYTHON" "$here/calls.py" call
costs "Python, run()$tab" "$PYTHON" "$here/calls.py" run
costs "Python, a step of sample()$tab" "$PYTHON" "$here/calls.py" sample
costs "Python, a coin of run_batch()$tab" "$PYTHON" "$here/calls.py" batch
costs "Python, a row of quaternion()$tab" "$PYTHON" "$here/calls.py" quaternion
costs "Python, a row of reaction()$tab" "$PYTHON" "$here/calls.py" reaction
