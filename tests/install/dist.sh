#!/bin/sh
# SPDX-License-Identifier: MIT
# A release must build and pass from a read-only folder, out of tree, and make
# itself again, byte for byte; and the library that the sources made here.
# From `make distcheck`: MAKE OUT VERSION TARBALL.
set -eu
work=$OUT/distcheck
src=$work/rollcoin-$VERSION

test ! -d "$work" || chmod -R u+w "$work"
rm -rf "$work"
mkdir -p "$work/out"
tar -xJf "$TARBALL" -C "$work"
chmod -R a-w "$src"
touch "$work/unpacked"

cd "$work/out"
run="$MAKE --no-print-directory -f $src/Makefile O=build"
$run all check installcheck
$run examples demo >demo.txt
$run dist
cmp "$TARBALL" "build/rollcoin-$VERSION.tar.xz"
single=rollcoin-single-$VERSION
cmp "$(dirname "$TARBALL")/$single.tar.xz" "build/$single.tar.xz"
for file in librollcoin.a "librollcoin.so.$VERSION" rollcoin.3; do
    cmp "$OUT/$file" "build/$file"
done
# The debug information must be there, or equal bytes would prove little.
readelf -S "build/librollcoin.so.$VERSION" | grep -q debug_info

# Root may write to what is read-only, so ask what was.
written=$(find "$src" -newer "$work/unpacked")
test -z "$written" || { echo "distcheck: written: $written" >&2; exit 1; }

chmod -R u+w "$src"
rm -rf "$work"
echo "distcheck: $(basename "$TARBALL") builds, passes and makes itself again"
