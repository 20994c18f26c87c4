#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs each fuzz target for its part of the time, from the inputs of its corpus
# and those found before; says how many calls it examined, and fails if one
# breaks a promise, or a function was never done, or never refused: of those a
# short run may miss one by chance, and is followed by one six times as long.
#     run.sh CORPUS OUT SECONDS TARGET...
set -eu
corpus=$1 out=$2 seconds=$3
shift 3
part=$((seconds / $#))
test "$part" -gt 0 || part=1
status=0
. "$(dirname "$0")/../at_once.sh"

fuzzes()
{
    # What frees memory late costs time here, and nothing frees.
    ASAN_OPTIONS=quarantine_size_mb=1 FUZZ_DEMANDS_ALL=1 \
        "$out/fuzz_$1" -max_total_time="$part" -max_len=192 -timeout=240 \
        -entropic=0 -print_final_stats=1 -artifact_prefix="$found-" \
        "$found" "$corpus/$1" >"$log" 2>&1
}

missed() { grep -q 'does not hold: .*every function was done' "$log"; }

# target NUMBER NAME
target()
{
    found=$out/found/$2
    log=$out/$2.log
    mkdir -p "$found" "$corpus/$2"
    if fuzzes "$2" || { missed && part=$((part * 6)) && fuzzes "$2"; }; then
        runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
        counts=$(sed -n 's/^count: /    /p' "$log")
        printf '%-14s %12d executions\n%s\n' "$2" "$runs" "$counts"
        return
    fi
    echo "fuzz: $2 FAILED"
    grep -E 'Seed|does not hold|^[ps] = |^argument|runtime error|ERROR|SUMMARY|^ *#|Base64' \
        "$log" | tail -30
    tail -3 "$log"
    return 1
}

printf '%s\n' "$@" | at_once target || status=1
for name; do cat "$out/$name.log"; done |
    awk '/^stat::number_of_executed_units/ { n += $2 }
        END { printf "fuzz: %d executions\n", n }'
exit $status
