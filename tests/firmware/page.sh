#!/bin/sh
# SPDX-License-Identifier: MIT
# The commands of docs/embedding.md, run as they stand in a copy of the sources,
# print what it says that they print.
# From `make firmware`: MAKE SRC OUT.
set -eu
work=$OUT/firmware/page
rm -rf "$work"
mkdir -p "$work/docs/examples"
cp -r "$SRC/Makefile" "$SRC/LICENSE" "$SRC/include" "$SRC/lib" \
    "$SRC/pkgconfig" "$work"
cp -r "$SRC/docs/examples/firmware" "$work/docs/examples"

# part FROM TO: those lines of the page.
part() { sed -n "/$1/,/$2/p" "$SRC/docs/embedding.md"; }

part '^    make single' 'kernel watchdog' | sed -n 's/^    //p' >"$work/commands"
part 'kernel watchdog' '^[^ ]' | sed -n 's/^    \([0-9]\)/\1/p' >"$work/says"
test "$(wc -l <"$work/says")" = 3

unset MAKEFLAGS # of the make that runs this
(cd "$work" && timeout 120 sh -e commands) >"$work/out" 2>&1 ||
    { tail -5 "$work/out"; exit 1; }
tail -3 "$work/out" | cmp - "$work/says"
echo "the page's firmware runs"
