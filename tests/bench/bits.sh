#!/bin/sh
# SPDX-License-Identifier: MIT
# Which bits a CSV of results was measured with: the hashes that the self-tests
# of coin.h and coinf.h are pinned to.
#     bits.sh SRC                  the line for the head of a CSV
#     bits.sh SRC FOLDER [warn]    names the files of FOLDER that other bits
#                                  made, and fails if there are any, but by warn
set -eu
hashes=$(grep -rhoE 'PINNED\w* UINT64_C\(0x[0-9a-f]{16}' "$1/lib" |
    sed 's/.*0x//' | LC_ALL=C sort)
test "$(echo "$hashes" | wc -w)" = 2 ||
    { echo "bits.sh: not two pinned hashes in lib/: $hashes" >&2; exit 2; }
line="# bits: $(echo $hashes)"
test $# -gt 1 || { echo "$line"; exit; }

renewed_by()
{
    case $1 in
    longrun | damping) echo longrun ;;
    models_*) echo models ;;
    silent*) echo silent ;;
    slides) echo slides ;;
    adversary) echo adversary adversary-update ;;
    *) echo charts ;;
    esac
}

stale=0
for file in "$2"/*.csv; do
    grep -qxF "$line" "$file" && continue
    name=$(basename "$file" .csv)
    echo "$name.csv: made by other bits than the code has:" \
        "make $(renewed_by "$name")"
    stale=$((stale + 1))
done
test $stale = 0 || test "${3-}" = warn
