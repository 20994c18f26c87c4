#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs as a user does and as a packager does; builds and runs a client
# through pkg-config against the shared and the static library; uninstalls.
# From `make installcheck`: MAKE CC PKG_CONFIG SRC OUT VERSION SOVERSION.
set -eu
client=$SRC/tests/install/client.c
work=$OUT/installcheck
rm -rf "$work"
mkdir -p "$work"

die() { echo "installcheck: $*" >&2; exit 1; }

# The files and links below a folder must be just those of the library, in
# include/ and in $2.
files_are()
{
    for file in "$2/librollcoin.a" "$2/librollcoin.so" \
        "$2/librollcoin.so.$SOVERSION" "$2/librollcoin.so.$VERSION" \
        "$2/pkgconfig/rollcoin.pc" "${2%%/lib*}/include/coin.h" \
        "${2%%/lib*}/include/coinf.h"; do
        echo "$file"
    done | LC_ALL=C sort >"$work/expected"
    (cd "$1" && find . ! -type d | sed 's/^.//' | LC_ALL=C sort) >"$work/found"
    diff "$work/expected" "$work/found" || die "wrong files below $1"
}

# Builds and runs the client: by $1, with pkg-config's $2, libraries in $3.
client_runs()
{
    # shellcheck disable=SC2046,SC2086
    $CC -std=c99 -Wall -Werror $1 "$client" -o "$work/client" \
        $($PKG_CONFIG $2 --cflags --libs rollcoin)
    LD_LIBRARY_PATH=$3 "$work/client" "$($PKG_CONFIG --modversion rollcoin)" ||
        die "the client fails $1"
}

# Both libraries, with pkg-config set up by the caller; libraries in $1.
clients_run()
{
    client_runs "" "" "$1"
    readelf -d "$work/client" | grep -q "NEEDED.*librollcoin.so.$SOVERSION\]" ||
        die "the client does not ask for librollcoin.so.$SOVERSION"
    client_runs -static --static ""
    ! readelf -d "$work/client" | grep -q NEEDED || die "not static"
}

unset DESTDIR PKG_CONFIG_PATH PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR

echo "installcheck: below a prefix"
prefix=$work/prefix
run="$MAKE --no-print-directory -f $SRC/Makefile O=$OUT PREFIX=$prefix"
$run install
files_are "$prefix" /lib
(export PKG_CONFIG_LIBDIR="$prefix/lib/pkgconfig"; clients_run "$prefix/lib")
$run uninstall
test -z "$(find "$prefix" ! -type d)" || die "uninstall leaves files"

echo "installcheck: staged for a package"
root=$work/root
lib=/usr/lib/$($CC -dumpmachine)
run="$MAKE --no-print-directory -f $SRC/Makefile O=$OUT DESTDIR=$root"
run="$run PREFIX=/usr LIBDIR=$lib"
$run install
files_are "$root" "$lib"
! grep -q "$work" "$root$lib/pkgconfig/rollcoin.pc" ||
    die "rollcoin.pc names the staging folder"
(
    export PKG_CONFIG_LIBDIR="$root$lib/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$root"
    clients_run "$root$lib"
)
$run uninstall
test -z "$(find "$root" ! -type d)" || die "uninstall leaves files"

echo "installcheck: shared and static clients run, nothing is left behind"
