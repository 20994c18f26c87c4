#!/bin/sh
# SPDX-License-Identifier: MIT
# The errors of a quarter's life by coin_settle() and by fixed steps, each with
# its cost in textbook Runge-Kutta steps.  That of coin_settle() is counted in
# instructions; a stage of a fixed step counts as one of the textbook's four.
# From `make real-fixed`: FIXED.
set -eu
command -v valgrind >/dev/null || { echo "needs valgrind" >&2; exit 1; }
one=1496 # instructions of a textbook step, by which all pages count

count()
{
    valgrind --tool=callgrind --callgrind-out-file="$FIXED.callgrind" \
        "$FIXED" count "$@" 2>&1 | sed -n 's/.*Collected : //p'
}

none=$(count rk8 1) # what a program takes without a life
"$FIXED" | while IFS=, read -r method setting nine late end how; do
    case $method in
    method) cost=cost ;;
    settle) cost=$((($(count settle "$setting") - none) / one)) ;;
    rk4) cost=$(awk "BEGIN { printf \"%d\", 8.019 / $setting }") ;;
    rk8) cost=$(awk "BEGIN { printf \"%d\", 8.019 / $setting * 11 / 4 }") ;;
    esac
    echo "$method,$setting,$cost,$nine,$late,$end,$how"
done
