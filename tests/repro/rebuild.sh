#!/bin/sh
# SPDX-License-Identifier: MIT
# The same sources give the same bytes: two copies of a release in folders of
# different names, built in parallel and in series, in tree and out of tree, by
# each compiler.
# From `make repro`: MAKE SRC OUT VERSION.
set -eu
work=$OUT/rebuild
name=rollcoin-$VERSION
rm -rf "$work"
. "$SRC/tests/at_once.sh"
mkdir -p "$work/one" "$work/another/deep/folder"

unset MAKEFLAGS # of the make that runs this
make="$MAKE --no-print-directory"
$make -f "$SRC/Makefile" "O=$work" dist
tar -xJf "$work/$name.tar.xz" -C "$work/one"
tar -xJf "$work/$name.tar.xz" -C "$work/another/deep/folder"

# rebuilt NUMBER COMPILER
rebuilt()
{
    $make -C "$work/one/$name" "O=$2" "CC=$2" -j8 all dist single >/dev/null
    out=$work/another/$2
    (
        cd "$work/another"
        $make -f "deep/folder/$name/Makefile" "O=$out" "CC=$2" -j1 all dist \
            single >/dev/null
    )
    for file in librollcoin.a "librollcoin.so.$VERSION" "$name.tar.xz" \
        "rollcoin-single-$VERSION.tar.xz" rollcoin.3 single/coin.h; do
        cmp "$work/one/$name/$2/$file" "$out/$file"
        echo "same bytes  $2 $file"
    done
    # The debug information must be there, or equal bytes would prove little.
    readelf -S "$out/librollcoin.so.$VERSION" | grep -q debug_info
}
at_once rebuilt <<END
gcc
clang
END
