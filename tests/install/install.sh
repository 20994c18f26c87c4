#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs as a user does and as a packager does; builds and runs a client
# through pkg-config against the shared and the static library; uninstalls.
# From `make installcheck`: MAKE CC CXX PKG_CONFIG SRC OUT VERSION SOVERSION.
set -eu
client=$SRC/tests/install/client.c
work=$OUT/installcheck
rm -rf "$work"
mkdir -p "$work"

die() { echo "installcheck: $*" >&2; exit 1; }

# The files and links below a folder must be just those of the library, in
# include/ and in $2, beside its documentation.
files_are()
{
    share=${2%%/lib*}/share
    {
        for file in "$2/librollcoin.a" "$2/librollcoin.so" \
            "$2/librollcoin.so.$SOVERSION" "$2/librollcoin.so.$VERSION" \
            "$2/pkgconfig/rollcoin.pc" "${2%%/lib*}/include/coin.h" \
            "${2%%/lib*}/include/coinf.h" "${2%%/lib*}/include/rollcoin.hpp" \
            "$share/man/man3/rollcoin.3" \
            "$2/cmake/rollcoin/rollcoin-config.cmake" \
            "$2/cmake/rollcoin/rollcoin-config-version.cmake"; do
            echo "$file"
        done
    } | LC_ALL=C sort >"$work/expected"
    (cd "$1" && find . ! -type d ! -path "*/share/doc/*" | sed 's/^.//' |
        LC_ALL=C sort) >"$work/found"
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

# Every page of docs/ that a header names is installed, and all that the pages
# link to.
docs_are_there()
{
    (cd "$1" && find . -name '*.md' | while read -r page; do
        grep -o '](\([^):#]*\)[#)]' "$page" | sed 's/^](//; s/.$//' |
            while read -r link; do
                test -e "${page%/*}/$link" || echo "$page: no $link"
            done
    done) >"$work/dead"
    test ! -s "$work/dead" || { cat "$work/dead"; die "dead links"; }
    grep -oh 'docs/[a-z]*\.md' "$SRC"/include/*.h | sort -u >"$work/named"
    test -s "$work/named" || die "the headers name no page"
    while read -r page; do
        test -s "$1/$page" || die "$page is named by a header, and not there"
    done <"$work/named"
}

# A program in C++ includes rollcoin.hpp, with pkg-config set up by the caller.
wrapper_is_found()
{
    echo '#include <rollcoin.hpp>
        int main() { rollcoin::selftest(); }' |
        # shellcheck disable=SC2046
        $CXX -std=c++17 -x c++ - -o "$work/wrapped" \
            $($PKG_CONFIG --cflags --libs rollcoin) &&
        LD_LIBRARY_PATH=$1 "$work/wrapped" || die "no rollcoin.hpp"
}

# A plugin takes the static library in, which is position-independent, and
# exports none of its symbols: docs/installing.md has the flag.
plugin_hides()
{
    flag=$(grep -o -- '-Wl,--exclude-libs,[a-z.]*' "$SRC/docs/installing.md" | head -1)
    echo '#include <coin.h>
        int plugin(void); int plugin(void) { return coin_selftest(); }' |
        $CC -I"$SRC/include" -fPIC -shared -Wl,-z,text -Wl,-z,defs "$flag" \
            -x c - -x none "$1/librollcoin.a" -lm -o "$work/plugin.so" ||
        die "a plugin cannot take librollcoin.a in"
    test "$(nm -D --defined-only "$work/plugin.so" | sed 's/.* //')" = plugin ||
        die "the plugin exports more than its own"
    echo 'int plugin(void); int main(void) { return plugin(); }' |
        $CC -x c - -x none "$work/plugin.so" -o "$work/host" -lm &&
        "$work/host" || die "the plugin does not run"
}

# refused NAME=VALUE...: make must refuse before anything is made.
refused()
{
    ! $MAKE --no-print-directory -f "$SRC/Makefile" "O=$work/made" "$@" install \
        >"$work/log" 2>&1 && grep -q 'with a blank in' "$work/log" &&
        test ! -e "$work/made" && test -z "$(find "$work" -path '*a b*')" ||
        die "not refused: $*"
}

unset DESTDIR PKG_CONFIG_PATH PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR

echo "installcheck: names with a blank"
for folder in O PREFIX DESTDIR LIBDIR MANDIR; do
    refused "PREFIX=$work/prefix" "$folder=$work/a b"
done

# Root tells the dynamic linker of the system, and only of what is installed in
# the system.
echo "installcheck: below a prefix"
prefix=$work/prefix
printf '#!/bin/sh\necho told >>%s\n' "$work/told" >"$work/ldconfig"
chmod +x "$work/ldconfig"
run="$MAKE --no-print-directory -f $SRC/Makefile O=$OUT PREFIX=$prefix"
run="$run FILLED=$work/filled LDCONFIG=$work/ldconfig"
$run install
test "$(id -u)" != 0 || test "$(cat "$work/told")" = told ||
    die "the dynamic linker was not told"
files_are "$prefix" /lib
docs_are_there "$prefix/share/doc/rollcoin"
plugin_hides "$prefix/lib"
test "$($run URL=https://example.org "$work/filled/rollcoin.pc" &&
    sed -n 's/^URL: //p' "$work/filled/rollcoin.pc")" = https://example.org ||
    die "rollcoin.pc has no URL"
page=$prefix/share/man/man3/rollcoin.3
mandoc -T lint "$page" >"$work/log" && test ! -s "$work/log" ||
    { cat "$work/log"; die "rollcoin(3) is not clean"; }
test "$(grep -cE '^(u?int32_t|double|const char) \*?coin_' "$page")" = \
    "$(grep -c '^COIN_API' "$SRC/include/coin.h")" ||
    die "rollcoin(3) has not each function of coin.h"
(
    export PKG_CONFIG_LIBDIR="$prefix/lib/pkgconfig"
    clients_run "$prefix/lib"
    wrapper_is_found "$prefix/lib"
)
$run uninstall
test -z "$(find "$prefix" ! -type d)" || die "uninstall leaves files"
rm -f "$work/told"

echo "installcheck: staged for a package"
root=$work/root
lib=/usr/lib/$($CC -dumpmachine)
run="$MAKE --no-print-directory -f $SRC/Makefile O=$OUT DESTDIR=$root"
run="$run PREFIX=/usr LIBDIR=$lib FILLED=$work LDCONFIG=$work/ldconfig"
$run install
test ! -e "$work/told" || die "the dynamic linker was told of a staged library"
files_are "$root" "$lib"
! grep -q "$work" "$root$lib/pkgconfig/rollcoin.pc" ||
    die "rollcoin.pc names the staging folder"
(
    export PKG_CONFIG_LIBDIR="$root$lib/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$root"
    clients_run "$root$lib"
)
$run uninstall
test -z "$(find "$root" ! -type d)" || die "uninstall leaves files"

echo "installcheck: several places in one folder"
run="$run LIBDIR=/one INCLUDEDIR=/one PKGCONFIGDIR=/one CMAKEDIR=/one"
$run install
for file in coin.h coinf.h librollcoin.a librollcoin.so rollcoin.pc \
    rollcoin-config.cmake rollcoin-config-version.cmake; do
    test -e "$root/one/$file" || die "$file is left out"
done
$run uninstall
test -z "$(find "$root" ! -type d)" || die "uninstall leaves files"

echo "installcheck: shared and static clients run, nothing is left behind"
