#!/bin/sh
# SPDX-License-Identifier: MIT
# A release must build and pass from a read-only folder, out of tree, and make
# itself again, byte for byte.
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

# Root may write to what is read-only, so ask what was.
written=$(find "$src" -newer "$work/unpacked")
test -z "$written" || { echo "distcheck: written: $written" >&2; exit 1; }

chmod -R u+w "$src"
rm -rf "$work"
echo "distcheck: $(basename "$TARBALL") builds, passes and makes itself again"
