#!/bin/sh
# SPDX-License-Identifier: MIT
# Compares headers and shared library with the baselines of this soname, in
# tests/abi/SOVERSION: every difference is a failure, an addition too, until
# `make abi-update` has accepted it.  docs/contributing.md explains each part.
#     abi.sh [update | release]
# From `make abi` and `make release`: CC SRC OUT VERSION SOVERSION PYTHON.
# LIBRARY and INCLUDE may name others than the ones just built.
set -eu
here=$SRC/tests/abi
base=${BASE:-$here/$SOVERSION}
library=${LIBRARY:-$OUT/librollcoin.so}
include=${INCLUDE:-$SRC/include}
work=$OUT/abi
failed=
export CC

die() { echo "abi: $*" >&2; exit 1; }
changed() { echo "abi: $1 changed"; failed="$failed $1"; }

for tool in abidw abidiff nm readelf clang "$PYTHON"; do
    command -v "$tool" >/dev/null || die "needs $tool"
done
# abidiff calls any two libraries equal if it is shown no debug information.
readelf -S "$library" | grep -q '\.debug_info' ||
    die "$library has no debug information: build it with -g"
case $VERSION in
0.*)
    test "$SOVERSION" = "${VERSION%.*}" ||
        die "before 1.0 the soname carries the minor version: $VERSION is not" \
            "librollcoin.so.$SOVERSION"
    ;;
esac
readelf -d "$library" | grep -q "SONAME.*\[librollcoin.so.$SOVERSION\]" ||
    die "$library is not librollcoin.so.$SOVERSION"

rm -rf "$work"
mkdir -p "$work/new"

# ---------------------------------------------------------------- what there is
# Loading addresses and sizes of code are nobody's business.
nm -D --defined-only --with-symbol-versions "$library" | sed 's/^[^ ]* //' |
    LC_ALL=C sort >"$work/new/symbols.txt"
for list in macros constants layout functions; do
    "$PYTHON" "$SRC/tests/ffi/header.py" "$include" $list >"$work/new/$list.txt"
done
abidw --exported-interfaces-only --no-corpus-path --no-comp-dir-path \
    --no-show-locs "$library" >"$work/new/rollcoin.abi"

# --------------------------------------------------------------- since a release
# What a release of this soname had stays, and what came since has symbols in
# nodes that no release has: a program that needs them is then refused by the
# releases that lack them.
node_of() { sed -n 's/.*@@*//p' "$1" | LC_ALL=C sort -u; }

grown_since_release()
{
    test -d "$base/released" || return 0
    for list in symbols macros constants functions; do
        LC_ALL=C comm -23 "$base/released/$list.txt" "$work/new/$list.txt"
    done >"$work/lost"
    "$PYTHON" "$here/layout.py" "$base/released/layout.txt" \
        "$work/new/layout.txt" >>"$work/lost" || :
    LC_ALL=C comm -13 "$base/released/symbols.txt" "$work/new/symbols.txt" |
        grep '@' >"$work/added" || :
    node_of "$base/released/symbols.txt" >"$work/nodes"
    node_of "$work/added" | LC_ALL=C comm -12 - "$work/nodes" |
        sed 's/.*/added to & of a release: begin a node in rollcoin.map/' \
            >>"$work/lost"
    test ! -s "$work/lost" || { cat "$work/lost"; return 1; }
}
grown_since_release || die "a break of the ABI of a release: take it back," \
    "or raise the number that the soname carries"

# ----------------------------------------------------------------------- update
bare_headers()
{
    mkdir -p "$base/include"
    for header in "$include"/*.h; do
        { head -1 "$header"
            gcc -fpreprocessed -dD -E -P -w "$header" | sed 's/ *$//'
        } >"$base/include/$(basename "$header")"
    done
}

case ${1:-} in
update)
    mkdir -p "$base"
    cp "$work/new"/* "$base"
    # The headers of a soname's first release stay, without their comments.
    test -d "$base/released" || bare_headers
    echo "abi: accepted as librollcoin.so.$SOVERSION:" \
        "$(wc -l <"$base/symbols.txt") symbols"
    exit
    ;;
release)
    rm -rf "$base/released"
    mkdir "$base/released"
    for list in symbols macros constants layout functions; do
        cp "$base/$list.txt" "$base/released"
    done
    echo "abi: librollcoin.so.$SOVERSION is released as it is"
    exit
    ;;
esac

# ----------------------------------------------------------------------- compare
for file in symbols.txt macros.txt constants.txt layout.txt functions.txt \
    rollcoin.abi include/coin.h; do
    test -s "$base/$file" || die "there is no $base/$file: make abi-update"
done
for list in symbols macros constants layout functions; do
    diff "$base/$list.txt" "$work/new/$list.txt" || changed $list
done
# Sizes and offsets are the same for processors of 32 bits and of 64.
{
    echo '#include <stddef.h>'
    find "$include" -name '*.h' -printf '#include <%P>\n' | LC_ALL=C sort
    sed -e 's/\(.*\)\.\(.*\) offset \(.*\) size \(.*\)/IS(offsetof(\1, \2) == \3);\
IS(sizeof((\1 *)0)->\2 == \4);/' -e 's/^\(coin.*\) size \(.*\)/IS(sizeof(\1) == \2);/' \
        "$work/new/layout.txt"
} >"$work/layout.c"
for target in i686-linux-gnu armv7-linux-gnueabihf wasm32 riscv32 x86_64-linux-gnu \
    x86_64-windows-gnu aarch64-linux-gnu s390x-linux-gnu; do
    clang --target=$target -std=c11 -ffreestanding -fsyntax-only -I"$include" \
        '-DIS(x)=_Static_assert(x, #x)' "$work/layout.c" || changed "$target"
done
abidiff --no-show-locs "$base/rollcoin.abi" "$library" || changed types

# A program compiled with the frozen headers, beside one compiled with today's,
# with the library of today.  It takes the address of all it knows of.
# client HEADERS NAME
client()
{
    "$PYTHON" "$SRC/tests/ffi/header.py" "$1" functions |
        sed 's/(.*//; s/.*[ *]//; s/.*/CALL(&)/' >"$work/calls.h"
    find "$1" -name '*.h' -printf '#include <%P>\n' | LC_ALL=C sort \
        >"$work/headers.h"
    $CC -std=c99 -O1 -I"$1" -I"$work" "$here/client.c" "$library" -lm \
        -o "$work/$2"
    LD_BIND_NOW=1 LD_LIBRARY_PATH=$(dirname "$library") "$work/$2" \
        >"$work/$2.txt"
}
client "$include" today && client "$base/include" frozen &&
    diff "$work/frozen.txt" "$work/today.txt" &&
    test -s "$work/today.txt" || changed client

test -z "$failed" || die "changed:$failed; if that is meant, make abi-update"
echo "abi: as programs know it: $(wc -l <"$base/symbols.txt") symbols," \
    "$(wc -l <"$base/layout.txt") sizes and offsets, the frozen client runs"
