#!/bin/sh
# SPDX-License-Identifier: MIT
# `make install HWCAPS=1`: the dynamic linker takes the shared library of the
# best level of x86-64 that the processor has, and of each level that it is
# told; all of them give the same bits.  A level that this processor lacks is
# built, and not run.
# From `make hwcaps`: MAKE CC SRC OUT SOVERSION.
set -eu
work=$OUT/hwcaps-check
lib=$work/prefix/lib
so=librollcoin.so.$SOVERSION
rm -rf "$work"
mkdir -p "$work"

die() { echo "hwcaps: $*" >&2; exit 1; }

case $($CC -dumpmachine) in
x86_64-*linux*) ;;
*)
    echo "hwcaps: not for $($CC -dumpmachine): nothing tested"
    exit
    ;;
esac
make="$MAKE --no-print-directory -f $SRC/Makefile O=$OUT FILLED=$work"
make="$make LDCONFIG=: HWCAPS=1 PREFIX=$work/prefix"
$make install
$CC -O1 -I"$SRC/include" "$SRC/tests/repro/hash.c" -L"$lib" -lrollcoin -lm \
    -o "$work/hash"
loader=$(readelf -l "$work/hash" | sed -n 's/.*interpreter: \(.*\)\]/\1/p')

# loaded MASK: the library that is loaded, by the name of its folder.
loaded()
{
    "$loader" --library-path "$lib" --glibc-hwcaps-mask "$1" --list \
        "$work/hash" | sed -n "s,.*=> $lib/\(.*\)$so .*,\1,p"
}

best=
for level in x86-64-v3 x86-64-v4; do
    objdump -d "$lib/glibc-hwcaps/$level/$so" >"$work/code"
    grep -q '%ymm' "$work/code" || die "$level has no wider vectors"
    ! grep -q 'vfn*m\(add\|sub\)' "$work/code" || die "$level is fused"
    if ! "$loader" --help | grep -q "$level (supported, searched)"; then
        echo "hwcaps: $level is built; this processor lacks it"
        continue
    fi
    best=$level
    test "$(loaded $level)" = "glibc-hwcaps/$level/" || die "$level is not loaded"
    "$loader" --library-path "$lib" --glibc-hwcaps-mask $level "$work/hash" |
        diff "$SRC/tests/repro/expected.txt" - || die "$level has other bits"
    echo "hwcaps: $level is loaded, with the same bits"
done
test "$(loaded none)" = "" || die "not the plain one without a level"
test -z "$best" || test "$(LD_LIBRARY_PATH=$lib ldd "$work/hash" |
    sed -n "s,.*=> $lib/\(.*\)$so .*,\1,p")" = "glibc-hwcaps/$best/" ||
    die "the best level is not taken"
$make uninstall
test -z "$(find "$work/prefix" ! -type d)" || die "uninstall leaves files"
