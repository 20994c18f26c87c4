#!/bin/sh
# SPDX-License-Identifier: MIT
# What a life costs, in instructions over those of a textbook Runge-Kutta step.
# From `make real-cost`: STUDY.
set -eu
command -v valgrind >/dev/null || { echo "needs valgrind" >&2; exit 1; }

count()
{
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$STUDY" "$@" \
        2>&1 | sed -n 's/.*Collected : //p'
}

# within NAME MOST TOTAL PARTS: parts are frames, or 1 for a whole life.
within()
{
    awk -v name="$1" -v most="$2" -v total="$3" -v parts="$4" -v one="$one" '
        BEGIN {
            steps = total / one / parts
            printf "%-42s %9.1f textbook steps, at most %g\n", name, steps, most
            exit steps > most
        }' || failed=1
}

failed=0
one=$(($(count textbook 11000) - $(count textbook 1000)))
one=$((one / 10000))
echo "a textbook step: $one instructions"
within "Euler's disk to rest at 1e-9" 90000 "$(count life 0 1e-9 0)" 1
within "a quarter to rest at 1e-9" 9000 "$(count life 1 1e-9 0)" 1
all=$(count life 0 1e-6 60)
within "Euler's disk, a frame at 1e-6, mean" 40 "$all" 6023
within "Euler's disk, the last frame" 200 \
    $((all - $(count life 0 1e-6 60 6022))) 1
all=$(count life 1 1e-6 60)
within "a quarter, a frame at 1e-6, mean" 40 "$all" 482
within "a quarter, the last frame" 200 \
    $((all - $(count life 1 1e-6 60 481))) 1

exit $failed
