#!/bin/sh
# SPDX-License-Identifier: MIT
# What coin.h and coinf.h declare, what rollcoin.map names and what the shared
# library exports are the same; other names shared between sources are
# coin_priv_* and coinf_priv_*.
# From `make lint`: CC SRC OUT.
set -eu
work=$OUT/lint
mkdir -p "$work"

$CC -E -P -DCOIN_API=EXPORT -I"$SRC/include" "$SRC/include/coinf.h" | tr '\n' ' ' |
    grep -o 'EXPORT [^(]*(' | sed 's/($//; s/.*[ *]//' |
    LC_ALL=C sort >"$work/declared"
sed -n '/global:/,/local:/s/^ *\(coinf*_[A-Za-z_0-9]*\);.*/\1/p' \
    "$SRC/lib/about/rollcoin.map" | LC_ALL=C sort >"$work/mapped"
nm -D --defined-only "$OUT/librollcoin.so" |
    sed -n 's/.* [^A ] \([^@]*\).*/\1/p' | LC_ALL=C sort >"$work/exported"
nm -g --defined-only "$OUT/librollcoin.a" |
    sed -n 's/.* [A-Z] \(.*\)/\1/p' | grep -v '^coinf*_priv_' |
    LC_ALL=C sort >"$work/global"

# coin_sizeof() knows every struct.
$CC -E -P -DCOIN_API= -I"$SRC/include" "$SRC/include/coinf.h" |
    sed -n 's/^} \(coinf*_[a-z_]*\);$/\1/p' |
    LC_ALL=C sort >"$work/sizes"
grep -o 'SIZE(coin[a-z_]*)' "$SRC/lib/about/sizes.c" | sed 's/SIZE(//; s/)//' |
    LC_ALL=C sort | diff "$work/sizes" -
echo "$(wc -l <"$work/sizes") structs, each with a size"

# A function of the library calls another one itself: no program can put its
# own in the place of that.
! objdump -R "$OUT/librollcoin.so" | grep 'coinf*_' ||
    { echo "called through the dynamic linker" && exit 1; }

test -s "$work/declared"
for list in mapped exported global; do
    echo "declared and $list: $(wc -l <"$work/$list") names"
    diff "$work/declared" "$work/$list"
done
