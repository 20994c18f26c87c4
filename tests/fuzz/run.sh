#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs each fuzz target for its part of the time, from the inputs of its corpus
# and those found before; says how many calls it examined, and fails if one
# breaks a promise, or a function was never done, or never refused: of those a
# short run may miss one by chance, and has two more.
#     run.sh CORPUS OUT SECONDS TARGET...
set -eu
corpus=$1 out=$2 seconds=$3
shift 3
part=$((seconds / $#))
test "$part" -gt 0 || part=1
total=0
status=0

runs()
{
    # What frees memory late costs time here, and nothing frees.
    ASAN_OPTIONS=quarantine_size_mb=1 FUZZ_DEMANDS_ALL=1 \
        "$out/fuzz_$1" -max_total_time="$part" -max_len=192 -timeout=240 \
        -entropic=0 -print_final_stats=1 -artifact_prefix="$found-" \
        "$found" "$corpus/$1" >"$log" 2>&1
}

missed() { grep -q 'does not hold: .*every function was done' "$log"; }

for target; do
    found=$out/found/$target
    log=$out/$target.log
    mkdir -p "$found" "$corpus/$target"
    if runs "$target" || { missed && runs "$target"; } ||
        { missed && runs "$target"; }
    then
        runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
        total=$((total + runs))
        printf '%-14s %12d executions\n' "$target" "$runs"
        sed -n 's/^count: /    /p' "$log"
    else
        status=1
        echo "fuzz: $target FAILED"
        grep -E 'Seed|does not hold|^[ps] = |^argument|runtime error|ERROR|SUMMARY|^ *#|Base64' \
            "$log" | tail -30
        tail -3 "$log"
    fi
done
echo "fuzz: $total executions"
exit $status
