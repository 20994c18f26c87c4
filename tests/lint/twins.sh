#!/bin/sh
# SPDX-License-Identifier: MIT
# coinf.h is coin.h in single precision: each of its functions has the prototype
# that float.awk makes of coin.h's, each of its structs the same members, and
# after them at most low.
# From `make lint`: CC SRC OUT.
set -eu
work=$OUT/lint
mkdir -p "$work"

# What a header declares, one to a line.
declared_by()
{
    $CC -E -P -DCOIN_API=EXPORT -I"$SRC/include" "$1" | tr '\n' ' ' |
        sed 's/  */ /g; s/EXPORT/\n&/g; s/typedef struct/\n&/g' |
        sed -n 's/^\(EXPORT .*);\).*/\1/p
            s/ float low\[[48]\];//
            s/^\(typedef struct .*} [a-z_]*;\).*/\1/p' |
        grep 'coinf_' | sed 's/ *\([()*,]\) */\1/g' | LC_ALL=C sort
}

LC_ALL=C awk -f "$SRC/lib/float/float.awk" "$SRC/include/coin.h" >"$work/turned.h"
declared_by "$work/turned.h" >"$work/turned"
declared_by "$SRC/include/coinf.h" >"$work/twins"
echo "$(wc -l <"$work/twins") declarations of coinf.h"
test "$(wc -l <"$work/twins")" -gt 20
if LC_ALL=C comm -23 "$work/twins" "$work/turned" | grep .; then
    echo "not as in coin.h"
    exit 1
fi
