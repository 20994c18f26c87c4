#!/bin/sh
# SPDX-License-Identifier: MIT
# Which bits a CSV of results was measured with: the hashes that the self-tests
# of coin.h and coinf.h are pinned to, and a hash of the lines of each kind in
# tests/repro/expected.txt.
#     bits.sh SRC           the line for the head of a CSV
#     bits.sh SRC FOLDER    fails if other bits made files of FOLDER, and names
#                           them
set -eu
expected=$1/tests/repro/expected.txt

pinned()
{
    hash=$(grep -hoE "PINNED UINT64_C\(0x[0-9a-f]{16}" "$1" | sed 's/.*0x//')
    test ${#hash} = 16 || { echo "bits.sh: no hash in $1" >&2; exit 2; }
    echo "$hash"
}

kinds()
{
    awk '$2 != "all" { print $3 }' "$expected" | LC_ALL=C sort -u
}

line="# bits: coin=$(pinned "$1/lib/about/selftest.c")"
line="$line coinf=$(pinned "$1/lib/float/coinf_selftest.c")"
for kind in $(kinds); do
    hash=$(awk -v k="$kind" '$3 == k' "$expected" | sha256sum | cut -c1-8)
    line="$line $kind=$hash"
done
test $# -gt 1 || { echo "$line"; exit; }

# The kinds that a CSV depends on, and what renews it.
about()
{
    case $1 in
    adversary) echo "$(kinds) coinf: adversary adversary-update" ;;
    batch) echo "batch: charts" ;;
    costs | frames | python) echo "coinf advance move settle: charts" ;;
    longrun | damping) echo ": longrun" ;;
    orbit_*) echo "orbit: charts" ;;
    accuracy) echo "advance orbit: charts" ;;
    silent*) echo ": silent" ;;
    slides) echo "advance move: slides" ;;
    engine_frames) echo "move: engine-frames" ;;
    luck_engines) echo "move: luck-engines" ;;
    luck_*) echo "move: luck" ;;
    *) echo "bits.sh: what does $1.csv depend on?" >&2; exit 2 ;;
    esac
}

stale=0
for file in "$2"/*.csv; do
    name=$(basename "$file" .csv)
    about=$(about "$name")
    head=$(grep '^# bits: ' "$file") || head=
    for kind in coin run ${about%%:*}; do
        word=$(echo "$line" | tr ' ' '\n' | grep "^$kind=")
        case "$head " in *" $word "*) continue ;; esac
        echo "$name.csv: made by other bits of $kind than the code has:" \
            "make${about#*:}"
        stale=$((stale + 1))
        break
    done
done
test $stale = 0
