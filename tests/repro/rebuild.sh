#!/bin/sh
# SPDX-License-Identifier: MIT
# The same sources give the same bytes by clang too: in folders of different
# names, in parallel and in series.  `make distcheck` looks at gcc, and at the
# tarball.
# From `make repro`: MAKE SRC OUT VERSION.
set -eu
work=$OUT/rebuild
copy=$work/another/deep/folder
rm -rf "$work"
mkdir -p "$copy"
(cd "$SRC" && tar -cf - Makefile README.md CHANGELOG.md LICENSE docs include \
    lib pkgconfig tests/studies) | tar -xf - -C "$copy"

unset MAKEFLAGS # of the make that runs this
make="$MAKE --no-print-directory CC=clang"
$make -f "$SRC/Makefile" "O=$work/one" -j2 all >/dev/null
cd "$work/another"
$make -f deep/folder/Makefile O=two -j1 all >/dev/null
for file in librollcoin.a "librollcoin.so.$VERSION"; do
    cmp "$work/one/$file" "two/$file"
    echo "same bytes  clang $file"
done
# The debug information must be there, or equal bytes would prove little.
readelf -S "two/librollcoin.so.$VERSION" | grep -q debug_info
