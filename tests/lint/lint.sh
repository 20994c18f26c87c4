#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs every lint, or those that take a moment; fails at the end if one did.
#     lint.sh [quick]
# From `make lint`: MAKE CC SRC OUT VERSION SOVERSION WARN.
set -eu
here=$SRC/tests/lint
failed=

run()
{
    title=$1
    shift
    echo "lint: $title"
    "$@" || failed="$failed; $title"
}

run "the sources' sizes" python3 "$here/sizes.py" "$SRC"
run "layers of lib/" python3 "$here/layers.py" "$SRC/lib"
run "each header of lib/ alone" sh "$here/alone.sh"
run "names of floats and vectors" python3 "$here/names.py" "$SRC" "$CC" "$OUT"
run "homes of equations" python3 "$here/homes.py" "$SRC"
run "mutants' texts" python3 "$SRC/tests/mutants/mutants.py" "$SRC"
run "citations" python3 "$here/citations.py" "$SRC"
run "tables of measurements" python3 "$SRC/tests/studies/bench/summary.py" \
    "$SRC/tests/studies/bench/results" "$SRC/docs/accuracy.md" "$SRC/docs/limits.md" \
    "$SRC/docs/luck.md" \
    "$SRC/tests/studies/tables.md" --check
run "quotes of tables" python3 "$here/quotes.py" "$SRC"
run "text" sh "$here/text.sh"
run "places of the version" sh "$here/version.sh"
run "public symbols" sh "$here/symbols.sh"
run "coinf.h beside coin.h" sh "$here/twins.sh"
run "what the objects need and hold" sh "$here/objects.sh"
run "what a call adds to a program" sh "$here/pay.sh"
test "${1-}" = quick || run "static analysis" sh "$here/analyse.sh"

test -z "$failed" || { echo "lint: FAILED:${failed#;}" >&2; exit 1; }
echo "lint: clean"
