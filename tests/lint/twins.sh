#!/bin/sh
# SPDX-License-Identifier: MIT
# coinf.h is coin.h in single precision: each of its functions has the prototype
# of coin.h's, and each of its structs the members, with float for double and
# coinf_ for coin_; after the members of a struct follows at most low.
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
        sed 's/ *\([()*,]\) */\1/g'
}

declared_by "$SRC/include/coin.h" |
    sed 's/\<double\>/float/g; s/\<coin_/coinf_/g' |
    LC_ALL=C sort >"$work/turned"
declared_by "$SRC/include/coinf.h" | grep coinf_ |
    LC_ALL=C sort >"$work/twins"
echo "$(wc -l <"$work/twins") declarations of coinf.h"
test "$(wc -l <"$work/twins")" -gt 20
if LC_ALL=C comm -23 "$work/twins" "$work/turned" | grep .; then
    echo "not as in coin.h"
    exit 1
fi
