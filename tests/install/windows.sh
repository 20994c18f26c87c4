#!/bin/sh
# SPDX-License-Identifier: MIT
# The whole for Windows, by mingw-w64: a DLL with its import library, which
# exports what the shared library of Linux does, moves coins by the pinned bits
# under wine, and is found where it was installed; and the tests, on the cmocka of
# one page of tests/memory, since Debian has none for mingw-w64.
# From `make windows`: MAKE SRC OUT VERSION SOVERSION.
set -eu
host=x86_64-w64-mingw32
cc=$host-gcc
work=$OUT/windows
dll=librollcoin-$SOVERSION.dll
mkdir -p "$work"

. "$SRC/tests/at_once.sh"
die() { echo "windows: $*" >&2; exit 1; }

wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
server=$(command -v wineserver || echo /usr/lib/wine/wineserver64)
for tool in $cc "$wine" "$server"; do
    command -v "$tool" >/dev/null || die "needs $tool"
done

# These have no part in Windows: test_pages runs a shell.  The truth of the others
# is a sine of the C library, which mingw-w64 takes from the x87: it errs by 2e-12
# of itself at 8, and by more farther out.
left_out="test_pages test_integrals test_sincos test_steady_at"

make="$MAKE --no-print-directory -f $SRC/Makefile O=$work CC=$cc"
make="$make CFLAGS=-O2 AR=$host-ar PKG_CONFIG=true CMOCKA=-I$SRC/tests/memory CMOCKA_LIBS="
$make all LDCONFIG=: PREFIX="$work/prefix" install
tests=
for source in "$SRC"/tests/test_*.c; do
    name=$(basename "$source" .c)
    case " $left_out " in
    *" $name "*) ;;
    *) tests="$tests tests/$name.c" ;;
    esac
done
# gcc adds .exe to a program's name; printf and the like are those of C99.
$make build-tests TESTS="$tests" CPPFLAGS="-D__USE_MINGW_ANSI_STDIO=1 -w" \
    >"$work/log" 2>&1 || { cat "$work/log"; die "the tests do not build"; }

# ---------------------------------------------------------------------- the DLL
$host-objdump -p "$work/prefix/bin/$dll" |
    sed -n '/\[Ordinal\/Name Pointer\] Table/,/^$/s/.*\] *\(coin.*\)/\1/p' |
    LC_ALL=C sort >"$work/exported"
sed -n 's/^ *\(coinf*_[A-Za-z_0-9]*\);.*/\1/p' "$SRC/lib/about/rollcoin.map" |
    LC_ALL=C sort | diff - "$work/exported" || die "the DLL exports other names"
for program in repro/hash.c install/client.c; do
    $cc -O1 -std=c11 -I"$work/prefix/include" "$SRC/tests/$program" \
        -L"$work/prefix/lib" -lrollcoin \
        -o "$work/prefix/bin/$(basename "$program" .c).exe"
done

# -------------------------------------------------------------------- under wine
export WINEPREFIX="$work/wine" WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml="
unset DISPLAY
mkdir -p "$WINEPREFIX"
trap '"$server" -k || :' EXIT
"$server" -p
run() { timeout 300 "$wine" "$@"; }
run "$work/prefix/bin/hash.exe" | tr -d '\r' |
    diff "$SRC/tests/repro/expected.txt" - || die "other bits"
run "$work/prefix/bin/client.exe" "$VERSION" || die "the client fails"
echo "windows: $dll has the bits and the names of Linux's"

# passes NUMBER FILE
passes()
{
    name=$(basename "$2" .c)
    run "$work/tests/run.exe" "$name" >"$work/tests/$name.log" 2>&1 && return
    tail -3 "$work/tests/$name.log"
    die "FAILED: $name"
}
# shellcheck disable=SC2086
printf '%s\n' $tests >"$work/files"
count=$(wc -l <"$work/files")
test "$count" -gt 40 || die "$count test files"
at_once passes <"$work/files"
echo "windows: $count test files pass under wine; not run: $left_out"
$make LDCONFIG=: PREFIX="$work/prefix" uninstall
rm "$work/prefix/bin/hash.exe" "$work/prefix/bin/client.exe"
test -z "$(find "$work/prefix" ! -type d)" || die "uninstall leaves files"
